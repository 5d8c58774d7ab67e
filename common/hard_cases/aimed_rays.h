#pragma once

#include "basics/box.h"
#include "basics/random_numbers.h"
#include "basics/ray.h"
#include "scene/mesh.h"
#include "structure/grid/grid.h"
#include "structure/kd_tree/kd_tree.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

// Families of rays that find the faults of structures and triangle tests; random rays are nearly
// blind to them. Each function takes the corners of at least one triangle, three per triangle.
// Origins lie in the box of the corners and half of its largest side around it, so within
// usual_reach, unless said otherwise. Directions are not normalised.

namespace raysteps {

// Rays of one kind.
struct RayFamily {
    std::string name;
    std::vector<Ray> rays;
};

inline constexpr float no_end = std::numeric_limits<float>::max();

float largest_side(const Box& box);

// A point of the box, or of the box grown by that much on every side.
glm::vec3 point_in_box(RandomNumbers& numbers, const Box& box, float grown_by = 0.0f);

glm::vec3 point_around(RandomNumbers& numbers, std::span<const glm::vec3> corners);

std::size_t any_corner(RandomNumbers& numbers, std::span<const glm::vec3> corners);

glm::vec3 point_on_edge(RandomNumbers& numbers, std::span<const glm::vec3> corners);

// From everywhere in the cube from -2 to 2, in any direction: many hits, many misses.
std::vector<Ray> random_rays(RandomNumbers& numbers, int count);

// From around the triangles to the middle of them.
std::vector<Ray> rays_at_triangles(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                   int count);

std::vector<Ray> rays_at_edges(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                               int count);

std::vector<Ray> rays_at_corners(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                 int count);

// At the corners of the triangles' own boxes: through edges and corners of leaves.
std::vector<Ray> rays_at_corners_of_boxes(RandomNumbers& numbers,
                                          std::span<const glm::vec3> corners, int count);

// From a corner to a corner: along edges, across faces, with origins on the surface.
std::vector<Ray> rays_between_corners(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                      int count);

std::vector<Ray> rays_from_inside(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                  int count);

// At points of triangles, almost in their planes: the angle, in radians, is that given, towards
// either side. They come from a largest side of all triangles away.
std::vector<Ray> grazing_rays(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                              float angle, int count);

// Along an axis, up or down, on both sides of t = 0; the other components are zeros of either sign.
// One of the origin's coordinates is a corner's, so that the ray runs in planes of the structure.
std::vector<Ray> axis_parallel_rays(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    int count);

// One component of the direction is zero, and the origin's coordinate there is that of the target,
// which is a point of an edge.
std::vector<Ray> rays_with_a_zero(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                  int count);

// t_min and t_max lie anywhere around the triangles, t_min below zero for half of them.
std::vector<Ray> segments(RandomNumbers& numbers, std::span<const glm::vec3> corners, int count);

// So short that t overflows, or so long that it nearly underflows. The shortest go along an axis,
// for what else they have would be denormal (docs/numerics.md, what is not covered).
std::vector<Ray> rays_of_extreme_length(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                        int count);

// At edges, from origins that many times farther away from the world's origin:
// beyond usual_reach.
std::vector<Ray> rays_from_far_away(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    float distance, int count);

// The same rays, with every t multiplied by the factor.
std::vector<Ray> with_large_t(std::vector<Ray> rays, float factor);

// Every ray from its end back to its start, in a straight line: from t = 3 to before t = 0.
std::vector<Ray> reversed(std::span<const Ray> rays);

// What no ray should be: NaN, infinite, without a direction, with a direction too small to divide
// by. A structure must answer all the same, and may not hang or read outside.
std::vector<Ray> nonsense_rays();

// All families of sensible rays that do not depend on a structure.
std::vector<RayFamily> ray_families(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    int count);

// Rays from inside a closed mesh around the world's origin (aimed_from_inside.cpp). Each must hit:
// one that does not has leaked out. Origins lie in the cube of that half side.

// At any point of any edge.
std::vector<Ray> edge_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                 int count);

// At any corner exactly, or as near as a rounded difference can be.
std::vector<Ray> corner_aimed_rays(RandomNumbers& numbers, const Mesh& mesh, const glm::vec3& half,
                                   int count);

// In any direction: to compare with.
std::vector<Ray> random_rays_from_inside(RandomNumbers& numbers, const glm::vec3& half, int count);

// Families for triangle tests, `count` rays each, each family from the same seed. Origins lie in
// the box of the mesh, so mostly inside of a closed one, unless said otherwise.
//   random    in any direction
//   inside    at points of triangles
//   edge      at points of edges, as nearly as floats say them
//   vertex    at corners: corner minus origin, rounded once
//   axis      along an axis, with one coordinate of a corner: in planes of the mesh
//   grazing   at points of triangles, at an angle of about 1e-4 to them
//   leaving   from points of triangles, moved off as chapter 03 does, in any direction
//   far       at points of triangles, from ten thousand sizes away
std::vector<RayFamily> families_from_inside(std::span<const glm::vec3> corners, std::size_t count,
                                            int seed);

// Rays aimed at the planes of a structure itself, where a walk can go wrong (aimed_at_planes.cpp).

// Planes at lower + i * step along each axis, i = 0 ... cells.
struct Lattice {
    glm::vec3 lower{0.0f};
    glm::vec3 step{1.0f};
    glm::ivec3 cells{1};
};

Lattice lattice_of(const GridShape& shape);

glm::vec3 any_lattice_point(RandomNumbers& numbers, const Lattice& lattice);

// From a lattice point to a lattice point, both moved out of the lattice along the ray by its
// length: they run through many lattice points on the way, and along edges of cells.
std::vector<Ray> rays_through_lattice_points(RandomNumbers& numbers, const Lattice& lattice,
                                             int count);

// In a plane of the lattice, in any direction.
std::vector<Ray> rays_in_lattice_planes(RandomNumbers& numbers, const Lattice& lattice, int count);

// Both, and the first ones back again.
std::vector<RayFamily> lattice_families(RandomNumbers& numbers, const Lattice& lattice, int count);

// For a kd-tree.

const Box& any_box(RandomNumbers& numbers, const KdTree& tree);

glm::vec3 any_box_corner(RandomNumbers& numbers, const KdTree& tree);

// At corners of boxes, where up to eight leaves meet.
std::vector<Ray> rays_at_box_corners(RandomNumbers& numbers, const KdTree& tree,
                                     std::span<const glm::vec3> corners, int count);

// From corner to corner of boxes, from before the first to behind the second.
std::vector<Ray> rays_through_box_corners(RandomNumbers& numbers, const KdTree& tree, int count);

// In a plane of the tree: one component of the direction is a zero of either sign.
std::vector<Ray> rays_in_box_planes(RandomNumbers& numbers, const KdTree& tree,
                                    std::span<const glm::vec3> corners, int count);

// In the plane of a split, in any direction from within the node that it splits.
std::vector<Ray> rays_in_split_planes(RandomNumbers& numbers, const KdTree& tree, int count);

// Along an edge of a box: in two planes at once.
std::vector<Ray> rays_along_box_edges(RandomNumbers& numbers, const KdTree& tree, int count);

std::vector<RayFamily> tree_families(RandomNumbers& numbers, const KdTree& tree,
                                     std::span<const glm::vec3> corners, int count);

// A ray and a box whose answer is known.
struct AimedBox {
    Ray ray;
    Box box;
    bool meets = true;
};

// Rays in the planes of a unit box's sides, along another axis, with zeros of either sign; and
// beside it by a millionth (B1).
std::vector<AimedBox> rays_in_sides_of_a_box();

// Boxes, flat along one axis or none, with a ray to one of their corners. All numbers are multiples
// of 2^-9 between -2 and 2, so the rays are exact (B2).
std::vector<AimedBox> rays_at_corners_of_any_box(RandomNumbers& numbers, int count);

// Boxes and rays that touch them, in one point or nearly so: where the ray comes to the first plane
// along x, it leaves by the last one along y, exactly, or less than a float later (B2). The first
// one is a box that room for 2 units in the last place does not save.
std::vector<AimedBox> rays_that_touch_a_box(RandomNumbers& numbers, int count);

// A unit box at an offset of a million and rays that pass its corner (B3).
std::vector<AimedBox> rays_far_from_zero();

// A unit box before, around and behind the origin, and rays that end at its entry or begin at its
// exit (B4).
std::vector<AimedBox> rays_that_end_at_a_box();

// The empty box, which no ray meets (B5).
std::vector<AimedBox> rays_at_the_empty_box(RandomNumbers& numbers, int count);

} // namespace raysteps
