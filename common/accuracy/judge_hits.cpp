#include "accuracy/judge_hits.h"

#include "geometry/box.h"
#include "reference/exact_nearest.h"
#include "structure/padding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace raysteps {

namespace {

bool share_a_corner(int a, int b, std::span<const glm::vec3> corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            if (corners[3 * static_cast<std::size_t>(a) + i] ==
                corners[3 * static_cast<std::size_t>(b) + j]) {
                return true;
            }
        }
    }
    return false;
}

// Whether a hit is at the triangle or at a neighbour of it; or both are misses.
bool is_there_too(int found, int true_triangle, std::span<const glm::vec3> corners) {
    if (found == no_triangle || true_triangle == no_triangle) {
        return found == true_triangle;
    }
    return share_a_corner(found, true_triangle, corners);
}

// How far rounding may move the ray, seen as a line.
float rounding_of(const Ray& ray, const Box& box) {
    const glm::vec3 farthest = glm::max(ray.origin - box.lower, box.upper - ray.origin);
    return static_cast<float>(
        padding_for(static_cast<double>(std::max({farthest.x, farthest.y, farthest.z}))));
}

// The ray moved by that much, aside of the axis along which it mainly goes: to four sides.
std::array<Ray, 4> moved_aside(const Ray& ray, float by) {
    const glm::vec3 size = glm::abs(ray.direction);
    const int along = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    std::array<Ray, 4> moved{ray, ray, ray, ray};
    for (std::size_t i = 0; i < 4; ++i) {
        moved[i].origin[(along + 1) % 3] += i % 2 == 0 ? by : -by;
        moved[i].origin[(along + 2) % 3] += i / 2 == 0 ? by : -by;
    }
    return moved;
}

// A ray whose hit is in question.
struct Disputed {
    std::size_t ray = 0;
    bool is_missed = false;
    int triangle = no_triangle; // that was missed, or hit where it should not be
    double t = 0.0;             // of it
};

// The ray moved by that much towards the middle of the triangle that was hit, or away from that of
// the one that was missed: past a sharp corner, no other way would do.
Ray moved_by_triangle(const Ray& ray, const Disputed& disputed, std::span<const glm::vec3> corners,
                      float by) {
    const auto first = 3 * static_cast<std::size_t>(disputed.triangle);
    const glm::dvec3 middle = (glm::dvec3(corners[first]) + glm::dvec3(corners[first + 1]) +
                               glm::dvec3(corners[first + 2])) /
                              3.0;
    const glm::dvec3 point = glm::dvec3(ray.origin) + disputed.t * glm::dvec3(ray.direction);
    const glm::dvec3 inwards = middle - point;
    const double length = glm::length(inwards);
    Ray moved = ray;
    if (length > 0.0) {
        const double step = static_cast<double>(disputed.is_missed ? -by : by);
        moved.origin = glm::vec3(glm::dvec3(ray.origin) + (step / length) * inwards);
    }
    return moved;
}

// Whether each of the rays passes an outline.
std::vector<bool> pass_outlines(std::span<const Disputed> disputed, std::span<const Ray> rays,
                                std::span<const ReferenceHit> truth,
                                std::span<const glm::vec3> corners) {
    const Box box = bounds_of(corners);
    std::vector<Ray> moved;
    for (const Disputed& one : disputed) {
        const Ray& ray = rays[one.ray];
        const float by = rounding_of(ray, box);
        const std::array<Ray, 4> sides = moved_aside(ray, by);
        moved.insert(moved.end(), sides.begin(), sides.end());
        moved.push_back(moved_by_triangle(ray, one, corners, by));
    }
    const std::vector<ReferenceHit> hits = exact_nearest_hits(moved, corners);
    constexpr std::size_t moves = 5; // of each ray
    std::vector<bool> outlines(disputed.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const int true_triangle = truth[disputed[i / moves].ray].triangle;
        if (!is_there_too(hits[i].triangle, true_triangle, corners)) {
            outlines[i / moves] = true;
        }
    }
    return outlines;
}

} // namespace

double unit_in_last_place(double value) {
    const auto size = static_cast<float>(std::abs(value));
    return static_cast<double>(std::nextafter(size, INFINITY)) - static_cast<double>(size);
}

Findings judge_hits(std::span<const Ray> rays, std::span<const Hit> hits,
                    std::span<const ReferenceHit> truth, std::span<const glm::vec3> corners) {
    std::vector<Disputed> disputed;
    std::vector<float> errors;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const auto t = static_cast<double>(hits[i].t);
        if (!is_there_too(hits[i].triangle, truth[i].triangle, corners)) {
            const bool is_there = truth[i].triangle != no_triangle;
            const bool found = hits[i].triangle != no_triangle;
            const bool is_missed = is_there && (!found || t > truth[i].t);
            disputed.push_back({i, is_missed, is_missed ? truth[i].triangle : hits[i].triangle,
                                is_missed ? truth[i].t : t});
        } else if (hits[i].triangle != no_triangle) {
            errors.push_back(
                static_cast<float>(std::abs(t - truth[i].t) / unit_in_last_place(truth[i].t)));
        }
    }
    const std::vector<bool> outlines = pass_outlines(disputed, rays, truth, corners);
    Fault missed{"missed", 0, hits.size()};
    Fault wrong{"false", 0, hits.size()};
    std::size_t excused = 0;
    for (std::size_t i = 0; i < disputed.size(); ++i) {
        excused += outlines[i] ? 1 : 0;
        missed.count += !outlines[i] && disputed[i].is_missed ? 1 : 0;
        wrong.count += !outlines[i] && !disputed[i].is_missed ? 1 : 0;
    }
    Findings findings{{missed, wrong}};
    if (excused > 0) {
        findings.measures.push_back({"at outlines", static_cast<double>(excused)});
    }
    if (!errors.empty()) {
        findings.error = summarize(errors);
    }
    return findings;
}

} // namespace raysteps
