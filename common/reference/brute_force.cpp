#include "reference/brute_force.h"

#include "basics/threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

// A corner, seen along the ray: where it falls on the plane of the two other axes, times the
// direction's longest component, and how far it lies along the longest axis.
struct SeenCorner {
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
};

// No division, and of floats in double neither overflow nor underflow.
SeenCorner look_at(const ReferenceRay& ray, const RayAxes& axes, const glm::dvec3& corner) {
    const glm::dvec3 p = corner - ray.origin;
    const glm::dvec3& d = ray.direction;
    return {p[axes.first] * d[axes.along] - p[axes.along] * d[axes.first],
            p[axes.second] * d[axes.along] - p[axes.along] * d[axes.second], p[axes.along]};
}

// On which side of the line from p to q the ray passes; and twice the area of the ray's point, p
// and q.
double side(const SeenCorner& p, const SeenCorner& q) {
    return p.x * q.y - p.y * q.x;
}

// -0 + 0 is +0: so an answer of zero has the same bits whatever signs its zeros came with.
double with_plain_zero(double value) {
    return value + 0.0;
}

} // namespace

RayAxes axes_of(const ReferenceRay& ray) {
    const glm::dvec3 length = glm::abs(ray.direction);
    if (length.x > length.y && length.x > length.z) {
        return {0, 1, 2};
    }
    if (length.y > length.z) {
        return {1, 2, 0};
    }
    return {2, 0, 1};
}

// The thought is that of Woop, Benthin and Wald ("Watertight ray/triangle intersection", 2013): a
// corner is projected by itself, so all its triangles see it at the same point. The rest is the
// problem of a point in plane triangles, and there the sign of `side` is right or 0, never wrong,
// because rounding keeps the order of the two products. Sides of 0 count as inside.
std::optional<TrianglePoint> meet(const ReferenceRay& ray, const RayAxes& axes, const glm::dvec3& a,
                                  const glm::dvec3& b, const glm::dvec3& c) {
    const SeenCorner seen_a = look_at(ray, axes, a);
    const SeenCorner seen_b = look_at(ray, axes, b);
    const SeenCorner seen_c = look_at(ray, axes, c);
    const double weight_a = side(seen_b, seen_c);
    const double weight_b = side(seen_c, seen_a);
    const double weight_c = side(seen_a, seen_b);
    const bool some_negative = weight_a < 0.0 || weight_b < 0.0 || weight_c < 0.0;
    const bool some_positive = weight_a > 0.0 || weight_b > 0.0 || weight_c > 0.0;
    if (some_negative == some_positive) { // outside, or all three are 0: seen edge-on
        return std::nullopt;
    }
    const double area = weight_a + weight_b + weight_c;
    const double t = (weight_a * seen_a.depth + weight_b * seen_b.depth + weight_c * seen_c.depth) /
                     (area * ray.direction[axes.along]);
    if (!(t >= ray.t_min && t <= ray.t_max)) { // also where t is NaN
        return std::nullopt;
    }
    // Rounding can lend an area to collinear corners. This sees that they have none wherever
    // differences of corners have at most 26 bits; beyond, they may count as a sliver.
    if (glm::cross(b - a, c - a) == glm::dvec3(0.0)) {
        return std::nullopt;
    }
    const double u = weight_b / area;
    const double v = std::min(weight_c / area, 1.0 - u); // so u + v is never over 1
    return TrianglePoint{with_plain_zero(t), with_plain_zero(u), with_plain_zero(v)};
}

ReferenceHit nearest_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners) {
    ReferenceHit nearest{.t = ray.t_max};
    const RayAxes axes = axes_of(ray);
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        const auto point = meet(ray, axes, corners[first], corners[first + 1], corners[first + 2]);
        if (!point) {
            continue;
        }
        // Of equal t the first, and so the smallest, index stays.
        if (nearest.triangle == no_triangle || point->t < nearest.t) {
            nearest = {point->t, point->u, point->v, static_cast<int>(first / 3)};
        }
    }
    return nearest;
}

ReferenceHit nearest_hit(const Ray& ray, std::span<const glm::vec3> corners) {
    return nearest_hit(reference_ray(ray), corners);
}

bool any_hit(const ReferenceRay& ray, std::span<const glm::vec3> corners) {
    const RayAxes axes = axes_of(ray);
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        if (meet(ray, axes, corners[first], corners[first + 1], corners[first + 2])) {
            return true;
        }
    }
    return false;
}

bool any_hit(const Ray& ray, std::span<const glm::vec3> corners) {
    return any_hit(reference_ray(ray), corners);
}

std::vector<ReferenceHit> nearest_hits(std::span<const Ray> rays,
                                       std::span<const glm::vec3> corners) {
    std::vector<ReferenceHit> hits(rays.size());
    on_threads(all_cores, rays.size(),
               [&](std::size_t i) { hits[i] = nearest_hit(rays[i], corners); });
    return hits;
}

} // namespace raysteps
