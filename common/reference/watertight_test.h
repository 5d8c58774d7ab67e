#pragma once

#include "reference/reference_ray.h"

#include <glm/vec3.hpp>

#include <optional>

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

// Where the ray meets the closed triangle, with t in [t_min, t_max]; nothing of a triangle of zero
// area or one seen edge-on. No ray slips between triangles that share an edge or a corner.
std::optional<TrianglePoint> meet(const ReferenceRay& ray, const RayAxes& axes, const glm::dvec3& a,
                                  const glm::dvec3& b, const glm::dvec3& c);

} // namespace raysteps
