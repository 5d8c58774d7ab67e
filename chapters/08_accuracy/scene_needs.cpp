#include "scene_needs.h"

#include "basics/box.h"
#include "basics/text.h"

#include <fmt/core.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>

namespace raysteps {

namespace {

constexpr double paper_epsilon = 1e-6;
constexpr double fixed_epsilon = 1e-4;
constexpr double sliver_ratio = 1000.0;
constexpr double float_digits = 24.0;
constexpr double digits_enough = 10.0; // a thousand steps along the smallest edge

// The bits of a corner, with one zero.
using CornerBits = std::array<std::uint32_t, 3>;

CornerBits bits_of(const glm::vec3& corner) {
    const auto bits = [](float value) {
        return std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value);
    };
    return {bits(corner.x), bits(corner.y), bits(corner.z)};
}

// Each edge needs one partner that goes the other way round.
int count_open_edges(const Scene& scene) {
    std::map<std::array<CornerBits, 2>, int> surplus; // of one way over the other
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        const std::size_t next = i - i % 3 + (i + 1) % 3;
        const CornerBits from = bits_of(scene.corners[i]);
        const CornerBits to = bits_of(scene.corners[next]);
        if (from != to) {
            const bool upwards = from < to;
            surplus[upwards ? std::array{from, to} : std::array{to, from}] += upwards ? 1 : -1;
        }
    }
    int open = 0;
    for (const auto& [edge, count] : surplus) {
        open += std::abs(count);
    }
    return open;
}

void add_triangle(SceneNeeds& needs, const glm::dvec3& a, const glm::dvec3& b,
                  const glm::dvec3& c) {
    const std::array edges{glm::length(b - a), glm::length(c - b), glm::length(a - c)};
    const auto [shortest, longest] = std::minmax_element(edges.begin(), edges.end());
    const double area = glm::length(glm::cross(b - a, c - a)); // twice
    if (area == 0.0) {
        ++needs.without_area;
        return;
    }
    needs.smallest_edge = std::min(needs.smallest_edge, *shortest);
    const double ratio = *longest * *longest / area;
    needs.thinnest = std::max(needs.thinnest, ratio);
    needs.slivers += ratio > sliver_ratio ? 1 : 0;
    needs.small_for_the_paper += area < paper_epsilon ? 1 : 0;
}

std::string closed_sentence(const SceneNeeds& needs) {
    if (needs.open_edges == 0) {
        return "The mesh is closed: a ray that slips between two triangles is a visible fault, so "
               "take a watertight test.";
    }
    return fmt::format(
        "The mesh is open: {} edges have no partner (holes, borders, or corners that "
        "differ in a bit). At all others a watertight test still closes every gap.",
        needs.open_edges);
}

} // namespace

SceneNeeds find_needs(const Scene& scene) {
    SceneNeeds needs;
    needs.triangles = triangle_count(scene);
    if (needs.triangles == 0) {
        return needs;
    }
    const Box box = bounds_of(scene.corners);
    const glm::vec3 side = box.upper - box.lower;
    const glm::vec3 farthest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    needs.size = static_cast<double>(std::max({side.x, side.y, side.z}));
    needs.largest_coordinate = static_cast<double>(std::max({farthest.x, farthest.y, farthest.z}));
    needs.smallest_edge = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.corners.size(); i += 3) {
        add_triangle(needs, glm::dvec3(scene.corners[i]), glm::dvec3(scene.corners[i + 1]),
                     glm::dvec3(scene.corners[i + 2]));
    }
    if (needs.without_area == needs.triangles) {
        needs.smallest_edge = 0.0;
    }
    needs.open_edges = count_open_edges(scene);
    if (needs.smallest_edge > 0.0) {
        needs.digits_left =
            std::clamp(float_digits + std::log2(needs.smallest_edge / needs.largest_coordinate),
                       0.0, float_digits);
    }
    return needs;
}

std::vector<std::string> to_sentences(const SceneNeeds& needs) {
    if (needs.triangles == 0) {
        return {"The scene has no triangle, so any method will do."};
    }
    std::vector<std::string> sentences{
        fmt::format("{} triangles; smallest edge {:.3g}, largest coordinate {:.4g}, size {:.4g}.",
                    needs.triangles, needs.smallest_edge, needs.largest_coordinate, needs.size),
        closed_sentence(needs)};
    sentences.push_back(
        needs.digits_left < digits_enough
            ? fmt::format(
                  "Beside the largest coordinate, a float has {:.1f} bits left for the smallest "
                  "edge: no test can fix that. Move the scene to the origin, or split it.",
                  needs.digits_left)
            : fmt::format(
                  "Beside the largest coordinate, a float has {:.1f} bits left for the smallest "
                  "edge: enough.",
                  needs.digits_left));
    sentences.push_back(
        needs.slivers > 0
            ? fmt::format(
                  "{} slivers, the thinnest 1 : {:.0f}: take exact areas, since rounded ones "
                  "leave t open along a sliver.",
                  needs.slivers, needs.thinnest)
            : fmt::format(
                  "No slivers (the thinnest triangle is 1 : {:.0f}): rounded areas will do.",
                  needs.thinnest));
    sentences.push_back(fmt::format(
        "The paper's fixed 1e-6 loses {} triangles ({:.3g} %), whose edges span less than "
        "that, even where a ray with a direction of length 1 meets them head on.",
        needs.small_for_the_paper, 100.0 * needs.small_for_the_paper / needs.triangles));
    if (needs.size > 0.0) {
        sentences.push_back(fmt::format(
            "A fixed offset of 1e-4 is {:.3g} % of the size, and {:.3g} of the "
            "smallest edge: {}.",
            100.0 * fixed_epsilon / needs.size, fixed_epsilon / needs.smallest_edge,
            fixed_epsilon > 0.1 * needs.smallest_edge ? "too much, take the error bound"
                                                      : "the error bound still asks for less"));
    }
    if (needs.without_area > 0) {
        sentences.push_back(
            fmt::format("{} triangles have no area: no test hits them.", needs.without_area));
    }
    return sentences;
}

} // namespace raysteps
