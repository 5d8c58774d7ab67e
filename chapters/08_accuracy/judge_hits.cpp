#include "judge_hits.h"

#include "basics/box.h"
#include "reference/exact.h"
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
    bool is_missed = false; // else there is one too many
};

glm::dvec3 corner_of(std::span<const glm::vec3> corners, int triangle, std::size_t corner) {
    return glm::dvec3(corners[3 * static_cast<std::size_t>(triangle) + corner]);
}

// The ray moved by that much away from the middle of the triangle that was missed: past a sharp
// corner, no other way would do.
Ray moved_off(const Ray& ray, const ReferenceHit& missed, std::span<const glm::vec3> corners,
              float by) {
    const glm::dvec3 middle =
        (corner_of(corners, missed.triangle, 0) + corner_of(corners, missed.triangle, 1) +
         corner_of(corners, missed.triangle, 2)) /
        3.0;
    const glm::dvec3 outwards =
        glm::dvec3(ray.origin) + missed.t * glm::dvec3(ray.direction) - middle;
    const double length = glm::length(outwards);
    Ray moved = ray;
    if (length > 0.0) {
        moved.origin += glm::vec3((static_cast<double>(by) / length) * outwards);
    }
    return moved;
}

// Whether the ray, somewhat after its start, comes so near to the point that the hit names. Then it
// passes beside the triangle, and nearer than rounding can tell.
bool comes_near(const Ray& ray, const Hit& hit, std::span<const glm::vec3> corners, float by) {
    const double u = std::clamp(static_cast<double>(hit.u), 0.0, 1.0);
    const double v = std::clamp(static_cast<double>(hit.v), 0.0, 1.0 - u);
    const glm::dvec3 point = (1.0 - u - v) * corner_of(corners, hit.triangle, 0) +
                             u * corner_of(corners, hit.triangle, 1) +
                             v * corner_of(corners, hit.triangle, 2);
    const glm::dvec3 way = static_cast<double>(hit.t) * glm::dvec3(ray.direction);
    const glm::dvec3 off = glm::abs(glm::dvec3(ray.origin) + way - point);
    const double farthest_off = std::max({off.x, off.y, off.z});
    const auto near = static_cast<double>(by);
    return farthest_off <= near && glm::length(way) > 4.0 * near;
}

struct Question {
    std::span<const Ray> rays;
    std::span<const Hit> hits;
    std::span<const ReferenceHit> truth;
    std::span<const glm::vec3> corners;
};

// Whether each of the rays passes an outline.
std::vector<bool> pass_outlines(std::span<const Disputed> disputed, const Question& question) {
    const Box box = bounds_of(question.corners);
    std::vector<bool> outlines(disputed.size());
    std::vector<Ray> moved;
    std::vector<std::size_t> moved_for; // which of the disputed
    for (std::size_t i = 0; i < disputed.size(); ++i) {
        const std::size_t n = disputed[i].ray;
        const Ray& ray = question.rays[n];
        const float by = rounding_of(ray, box);
        outlines[i] =
            !disputed[i].is_missed && comes_near(ray, question.hits[n], question.corners, by);
        const std::array<Ray, 4> sides = moved_aside(ray, by);
        moved.insert(moved.end(), sides.begin(), sides.end());
        if (disputed[i].is_missed) {
            moved.push_back(moved_off(ray, question.truth[n], question.corners, by));
        }
        moved_for.resize(moved.size(), i);
    }
    const std::vector<ReferenceHit> found = exact_nearest_hits(moved, question.corners);
    for (std::size_t k = 0; k < moved.size(); ++k) {
        const int true_triangle = question.truth[disputed[moved_for[k]].ray].triangle;
        if (!is_there_too(found[k].triangle, true_triangle, question.corners)) {
            outlines[moved_for[k]] = true;
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
            disputed.push_back({i, is_there && (!found || t > truth[i].t)});
        } else if (hits[i].triangle != no_triangle) {
            errors.push_back(
                static_cast<float>(std::abs(t - truth[i].t) / unit_in_last_place(truth[i].t)));
        }
    }
    const std::vector<bool> outlines = pass_outlines(disputed, {rays, hits, truth, corners});
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
