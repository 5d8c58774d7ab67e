#pragma once

#include "basics/random_numbers.h"
#include "hard_cases/aimed_rays.h"
#include "scene/mesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace raysteps {

// Surfaces that a ray leaves right after it has hit them, where acne and leaks come from.

// A direction of length 1, each equally likely.
glm::vec3 any_direction(RandomNumbers& numbers);

// A mesh and a ray at a point inside its first triangles.
struct SeenSurface {
    Mesh mesh;
    Ray ray;
};

// A triangle of that size, that far from the world's origin, seen from three sizes away.
SeenSurface any_triangle(RandomNumbers& numbers, float size, float offset);

// Two triangles that make a parallelogram, anywhere up to 10 from the origin, in any direction.
SeenSurface any_parallelogram(RandomNumbers& numbers);

// A ball of 80 triangles around zero, of radius 1, seen from outside at any point.
SeenSurface any_point_of_a_ball(RandomNumbers& numbers);

// Two spheres around the origin, of the radii 1 and 1 + gap; the first half of the triangles is the
// inner one.
Mesh close_spheres(float gap);

// Closed meshes around the world's origin that are harder than a ball of even triangles.

// A sphere of that radius by lines of latitude and longitude: 2 * around * (rows - 1) triangles. At
// the poles as many triangles as there are around share one corner.
Mesh latitude_sphere(float radius, int rows, int around);

// The sphere with 1,520 triangles and the radius 2.
Mesh shared_edge_sphere();

// A sphere of radius 1, stretched along x: slivers that many times longer than wide.
Mesh sliver_ball(float times);

// A lens of radius 1, and so high in its middle: from inside, rays to its rim graze its faces.
Mesh flat_lens(float height);

// Closed meshes with triangles whose corners lie on one line, which close slits
// (loaded_meshes.cpp).

// The mesh as the OBJ loader gives it back.
Mesh as_loaded(const Mesh& mesh);

// Of each triangle of a closed mesh, one edge that it shares is split at its middle; the neighbour
// keeps the whole edge, and a triangle without area closes the slit between both. The corners are
// multiples of 2^-10 between -4 and 4, so the middles are exact.
Mesh split_on_one_side(const Mesh& mesh);

// A sphere as latitude_sphere makes it, with each radius between 0.95 and 1.05, and its corners
// rounded where they lie around that center: far from zero some of its triangles lose their area.
Mesh jittered_sphere(RandomNumbers& numbers, int rows, int around, const glm::vec3& center);

// The corners of all triangles without area.
std::vector<glm::vec3> corners_without_area(const Mesh& mesh);

// The mesh, each corner multiplied and then moved, with rounding.
Mesh scaled_and_moved(Mesh mesh, float scale, const glm::vec3& offset);

// A mesh of these corners, three per triangle; its normals are those of the triangles, and (0, 0,
// 1) where a triangle has none.
Mesh mesh_of(std::vector<glm::vec3> corners);

// Triangles without order in and around the cube from -1 to 1.
Mesh random_triangles(RandomNumbers& numbers, int count);

// The same, but a thousand times longer than wide.
Mesh random_slivers(RandomNumbers& numbers, int count);

// The mesh with all corners in one plane across that axis.
Mesh flattened(Mesh mesh, int axis, float place);

// Meshes that lie across the cells of a grid or the leaves of a kd-tree, or in their very planes.

// Triangle 0 is listed in the first of four cells along x and hit in the fourth; triangle 1 lies
// between, and is nearer for a ray along x through (0, 0.5, 0.5).
Mesh long_triangle_before_a_small_one();

// The same among clutter, for trees: the small triangle, 1, is around that point.
struct LongAndSmall {
    Mesh mesh;
    glm::vec3 small{0.0f};
};
LongAndSmall long_triangle_before_a_small_one_among_clutter(RandomNumbers& numbers);

// Five walls of squares perpendicular to each axis, at whole coordinates from 0 to 4: every good
// plane of a kd-tree is one of theirs.
Mesh walls_at_whole_coordinates();

// Loose triangles, and behind them a wall at x = 0, 80 wide and high, of two triangles that share
// the edge y = z.
Mesh wall_behind_loose_triangles(RandomNumbers& numbers);

// A box from -1 to 1, and triangles perpendicular to each axis in the planes of its own grid of
// that many cells along each axis, with corners where three planes meet.
Mesh triangles_in_planes_of_cells(RandomNumbers& numbers, int cells);

// A ball of 980 triangles among twenty triangles a thousand times as large: a teapot in a stadium.
Mesh teapot_in_a_stadium(RandomNumbers& numbers);

// Triangles in the same place: which one is hit must not depend on the order of a walk.

// `count` copies of one triangle.
Mesh copies_of_a_triangle(int count);

// Each triangle once more at the end, and once more with its corners the other way round.
Mesh tripled(const Mesh& mesh);

enum class TriangleOrder { forward, backward, shuffled };

inline constexpr std::array all_orders{TriangleOrder::forward, TriangleOrder::backward,
                                       TriangleOrder::shuffled};

// The triangles in another order.
Mesh reordered(const Mesh& mesh, TriangleOrder order, int seed = 99);

// Corners of triangles that tempt the builder of a tree into depth, into endless splits, or out of
// the numbers. Three corners per triangle.

// The triangle with a box of the sides 2 a around the center, but for rounding.
std::vector<glm::vec3> triangle_around(const glm::vec3& center, const glm::vec3& a);

// Triangles of all sizes up to 1 around the world's origin: their boxes have the same centre,
// exactly.
std::vector<glm::vec3> concentric_triangles(int seed, int count);

// Triangles at 2^i along each axis, i = -60 ... 60, each as large as that.
std::vector<glm::vec3> triangles_at_powers_of_two();

// Triangles around the origin, each larger than the one before: a tree that grows by insertion
// becomes a chain.
std::vector<glm::vec3> shells(int count);

// Two heaps of triangles, 1.6e30 apart: their surface areas overflow a float.
std::vector<glm::vec3> heaps_at_the_end_of_floats(int seed);

// A box with another one in its corner: half of the planes of one are planes of the other.
std::vector<glm::vec3> box_in_the_corner_of_a_box();

// Small triangles at x = 1, 2, 4 ... 8192: planes that halve the way to them put off thirteen nodes
// before the first leaf, more than a short stack has room for.
std::vector<glm::vec3> triangles_at_doubling_distances();

} // namespace raysteps
