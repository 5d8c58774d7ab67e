#include "judges.h"

#include "basics/box.h"
#include "basics/error.h"
#include "image/color.h"
#include "image/difference.h"
#include "reference/exact.h"
#include "structure/padding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

namespace {

glm::dvec3 corner_of(std::span<const glm::vec3> corners, int triangle, std::size_t corner) {
    return glm::dvec3(corners[3 * static_cast<std::size_t>(triangle) + corner]);
}

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

// How far rounding may move the ray, seen as a line.
float rounding_of(const Ray& ray, const Box& box) {
    const glm::vec3 farthest = glm::max(ray.origin - box.lower, box.upper - ray.origin);
    return static_cast<float>(
        padding_for(static_cast<double>(std::max({farthest.x, farthest.y, farthest.z}))));
}

// Where a ray's line meets the plane of a triangle, without rounding, and by how much t changes
// there for each unit of length by which the ray is moved along every axis.
struct PlaneCrossing {
    double t = 0.0;
    double steepness = 0.0;
};

// Nothing where the ray is parallel to the plane, or the triangle has no area.
std::optional<PlaneCrossing> crossing_of(const Ray& ray, int triangle,
                                         std::span<const glm::vec3> corners) {
    const auto first = 3 * static_cast<std::size_t>(triangle);
    const ExactSolution solution =
        solve_exactly(ray, {corners[first], corners[first + 1], corners[first + 2]});
    const glm::dvec3 a = corner_of(corners, triangle, 0);
    const glm::dvec3 normal =
        glm::cross(corner_of(corners, triangle, 1) - a, corner_of(corners, triangle, 2) - a);
    const double along = std::abs(glm::dot(normal, glm::dvec3(ray.direction)));
    if (!solution.unique || along == 0.0) {
        return std::nullopt;
    }
    const double across = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    return PlaneCrossing{nearest_double(solution.t), across / along};
}

// The true t of the triangle that a method names, where that is the true one or does as well: a
// neighbour that the ray cannot be told to miss. Nothing where the triangle is another one.
//
// A neighbour does as well if the ray, moved by at most `by` along each axis, runs through a point
// that the two share, and so meets both planes at one and the same t. A plane n x = c is met at
// t = (c - n o) / (n d). To move the origin o by at most `by` along each axis changes that by at
// most by (|n_x| + |n_y| + |n_z|) / |n d|, exactly. So without being moved the ray meets the two
// planes at t that differ by no more than the two changes together. Where they differ by more, no
// ray that is so near runs through what they share: whoever names the neighbour lost the triangle.
std::optional<double> true_t_of(int found, const ReferenceHit& truth, const Ray& ray,
                                std::span<const glm::vec3> corners, double by) {
    if (found == truth.triangle) {
        return truth.t;
    }
    if (found == no_triangle || truth.triangle == no_triangle ||
        !share_a_corner(found, truth.triangle, corners)) {
        return std::nullopt;
    }
    const std::optional<PlaneCrossing> there = crossing_of(ray, found, corners);
    const std::optional<PlaneCrossing> here = crossing_of(ray, truth.triangle, corners);
    if (!there || !here ||
        std::abs(there->t - here->t) > by * (there->steepness + here->steepness)) {
        return std::nullopt;
    }
    return there->t;
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
    const ExactMesh& mesh;
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
    const std::vector<ReferenceHit> found = question.mesh.nearest_hits(moved);
    for (std::size_t k = 0; k < moved.size(); ++k) {
        const std::size_t n = disputed[moved_for[k]].ray;
        // Moved once already, it may have to go back as far.
        const double by = 2.0 * static_cast<double>(rounding_of(question.rays[n], box));
        if (!true_t_of(found[k].triangle, question.truth[n], moved[k], question.corners, by)) {
            outlines[moved_for[k]] = true;
        }
    }
    return outlines;
}

constexpr int window = 8;
constexpr double window_pixels = window * window;

// The constants of the source, for brightness from 0 to 1.
constexpr double steady_mean = 0.01 * 0.01;
constexpr double steady_variance = 0.03 * 0.03;

// Rec. 709.
double brightness(const glm::vec3& color) {
    const float linear = 0.2126f * color.x + 0.7152f * color.y + 0.0722f * color.z;
    return static_cast<double>(srgb_from_linear(std::clamp(linear, 0.0f, 1.0f)));
}

double similarity_of_windows(const Image& a, const Image& b, int column, int row) {
    double sum_a = 0.0;
    double sum_b = 0.0;
    double sum_aa = 0.0;
    double sum_bb = 0.0;
    double sum_ab = 0.0;
    for (int y = row; y < row + window; ++y) {
        for (int x = column; x < column + window; ++x) {
            const double p = brightness(a.at(x, y));
            const double q = brightness(b.at(x, y));
            sum_a += p;
            sum_b += q;
            sum_aa += p * p;
            sum_bb += q * q;
            sum_ab += p * q;
        }
    }
    const double mean_a = sum_a / window_pixels;
    const double mean_b = sum_b / window_pixels;
    const double variance_a = sum_aa / window_pixels - mean_a * mean_a;
    const double variance_b = sum_bb / window_pixels - mean_b * mean_b;
    const double covariance = sum_ab / window_pixels - mean_a * mean_b;
    return (2.0 * mean_a * mean_b + steady_mean) * (2.0 * covariance + steady_variance) /
           ((mean_a * mean_a + mean_b * mean_b + steady_mean) *
            (variance_a + variance_b + steady_variance));
}

constexpr float steps_of_srgb = 255.0f;
constexpr glm::vec3 mark{0.9f, 0.02f, 0.02f};

float steps_between(const glm::vec3& a, const glm::vec3& b) {
    float most = 0.0f;
    for (int c = 0; c < 3; ++c) {
        const float p = srgb_from_linear(std::clamp(a[c], 0.0f, 1.0f));
        const float q = srgb_from_linear(std::clamp(b[c], 0.0f, 1.0f));
        most = std::max(most, steps_of_srgb * std::abs(p - q));
    }
    return most;
}

} // namespace

double unit_in_last_place(double value) {
    const auto size = static_cast<float>(std::abs(value));
    return static_cast<double>(std::nextafter(size, INFINITY)) - static_cast<double>(size);
}

Findings judge_hits(std::span<const Ray> rays, std::span<const Hit> hits,
                    std::span<const ReferenceHit> truth, const ExactMesh& mesh) {
    const std::span<const glm::vec3> corners = mesh.corners();
    std::vector<Disputed> disputed;
    std::vector<float> errors;
    const Box box = bounds_of(corners);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const auto t = static_cast<double>(hits[i].t);
        const std::optional<double> true_t =
            true_t_of(hits[i].triangle, truth[i], rays[i], corners,
                      static_cast<double>(rounding_of(rays[i], box)));
        if (!true_t) {
            const bool is_there = truth[i].triangle != no_triangle;
            const bool found = hits[i].triangle != no_triangle;
            disputed.push_back({i, is_there && (!found || t > truth[i].t)});
        } else if (hits[i].triangle != no_triangle) {
            errors.push_back(
                static_cast<float>(std::abs(t - *true_t) / unit_in_last_place(*true_t)));
        }
    }
    const std::vector<bool> outlines = pass_outlines(disputed, {rays, hits, truth, mesh, corners});
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

double structural_similarity(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.width < window || a.height < window) {
        throw InputError("Pictures of " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                         " and " + std::to_string(b.width) + "x" + std::to_string(b.height) +
                         " pixels cannot be compared. Give two of one size, 8x8 at least.");
    }
    double sum = 0.0;
    double windows = 0.0;
    for (int row = 0; row + window <= a.height; row += window / 2) {
        for (int column = 0; column + window <= a.width; column += window / 2) {
            sum += similarity_of_windows(a, b, column, row);
            windows += 1.0;
        }
    }
    return sum / windows;
}

Findings judge_picture(const Image& picture, const Image& truth) {
    Fault visible{"visible pixels", 0, picture.pixels.size()};
    std::vector<float> errors;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        errors.push_back(steps_between(picture.pixels[i], truth.pixels[i]));
        visible.count += errors.back() > 1.0f ? 1 : 0;
    }
    return {{visible},
            summarize(errors),
            {{"RMSE", difference(picture, truth, 0.0f).rmse},
             {"similarity", structural_similarity(picture, truth)}}};
}

Image mark_differences(const Image& picture, const Image& truth) {
    Image marked = picture;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::vec3& color = picture.pixels[i];
        const float grey = 0.3f + 0.5f * (color.x + color.y + color.z) / 3.0f;
        marked.pixels[i] = steps_between(color, truth.pixels[i]) > 1.0f ? mark : glm::vec3(grey);
    }
    return marked;
}

} // namespace raysteps
