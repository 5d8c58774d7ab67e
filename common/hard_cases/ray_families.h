#pragma once

#include "geometry/box.h"
#include "hard_cases/ray_family.h"
#include "scene/random_numbers.h"

#include <limits>
#include <span>
#include <vector>

// Families of rays that find the faults of structures and triangle tests; random rays are nearly
// blind for them. Each function takes the corners of at least one triangle, three a triangle.
// Origins lie in the box of the corners and half of its largest side around it, so within
// usual_reach, unless said otherwise. Directions are not normalised.
namespace raysteps {

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

// At edges, from origins so many times as far away from the world's origin as around the triangles:
// beyond usual_reach.
std::vector<Ray> rays_from_far_away(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    float distance, int count);

// The same rays, with every t multiplied by the factor.
std::vector<Ray> with_large_t(std::vector<Ray> rays, float factor);

// Every ray from its end back to its start, as the crow flies: from t = 3 to before t = 0.
std::vector<Ray> reversed(std::span<const Ray> rays);

// What no ray should be. A structure must answer all the same, and may not hang or read outside:
// not a number, infinite, without a direction, with a direction too small to divide by.
std::vector<Ray> nonsense_rays();

// All families of sensible rays that know nothing of a structure.
std::vector<RayFamily> ray_families(RandomNumbers& numbers, std::span<const glm::vec3> corners,
                                    int count);

} // namespace raysteps
