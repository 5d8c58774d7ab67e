#pragma once

#include "basics/ray.h"
#include "reference/exact.h"
#include "reference/reference_ray.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace raysteps {

// A point of a triangle (a, b, c): (1 - u - v) * a + u * b + v * c, at t along the ray.
struct TrianglePoint {
    double t = 0.0;
    double u = 0.0;
    double v = 0.0;
};

// Numbers of the axes, 0 to 2: along the one, the direction is longest.
struct RayAxes {
    int along = 2;
    int first = 0;
    int second = 1;
};

RayAxes axes_of(const ReferenceRay& ray);

// Where the ray meets the closed triangle, with t in [t_min, t_max]; nothing for a triangle of zero
// area or one seen edge-on. No ray slips between triangles that share an edge or a corner.
std::optional<TrianglePoint> meet(const ReferenceRay& ray, const RayAxes& axes, const glm::dvec3& a,
                                  const glm::dvec3& b, const glm::dvec3& c);

// The nearest triangle, found by testing every triangle in double with a watertight test; of equal
// t the smallest index wins. Triangle i has the corners 3i, 3i + 1 and 3i + 2. Closed as
// exact_intersection is: edges, corners, t_min and t_max belong. A ray that is not finite misses.
ReferenceHit nearest_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners);
ReferenceHit nearest_hit(const Ray& ray, std::span<const glm::vec3> corners);

// Whether the ray meets any triangle.
bool any_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners);
bool any_hit(const Ray& ray, std::span<const glm::vec3> corners);

// nearest_hit of each ray, on all cores.
std::vector<ReferenceHit> nearest_hits(std::span<const Ray> rays,
                                       std::span<const glm::vec3> corners);

} // namespace raysteps
