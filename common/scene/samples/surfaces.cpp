#include "scene/samples/samples.h"

#include "basics/random_numbers.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace raysteps {

Mesh closed_tube(const std::vector<TubeSection>& sections, double radius, int sides) {
    const int rings = static_cast<int>(sections.size());
    Mesh points; // one corner and normal for each section and side
    for (const TubeSection& section : sections) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            const glm::dvec3 normal =
                std::cos(angle) * section.right + std::sin(angle) * section.up;
            points.corners.push_back(glm::vec3(section.center + radius * normal));
            points.normals.push_back(glm::vec3(normal));
        }
    }
    Mesh mesh;
    const auto add_corner = [&](int ring, int side) {
        const int index = ring % rings * sides + side % sides;
        mesh.corners.push_back(points.corners[index]);
        mesh.normals.push_back(points.normals[index]);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            add_corner(ring, side);
            add_corner(ring, side + 1);
            add_corner(ring + 1, side + 1);
            add_corner(ring, side);
            add_corner(ring + 1, side + 1);
            add_corner(ring + 1, side);
        }
    }
    return mesh;
}

namespace {

constexpr double around_axis = 7.0;
constexpr double around_ring = 16.0;
constexpr double ring_radius = 1.25;
constexpr double winding_radius = 0.70;
constexpr double tube_radius = 0.10;

// Turn is in [0, 1). The knot lies on a torus; the torus' normal is perpendicular to the knot, so
// it and the tangent span a frame that comes back to itself after a turn.
TubeSection knot_section(double turn) {
    const double axis_angle = 2.0 * std::numbers::pi * around_axis * turn;
    const double ring_angle = 2.0 * std::numbers::pi * around_ring * turn;
    const glm::dvec3 radial{std::cos(axis_angle), std::sin(axis_angle), 0.0};
    const glm::dvec3 along_axis_turn{-std::sin(axis_angle), std::cos(axis_angle), 0.0};
    const glm::dvec3 axis{0.0, 0.0, 1.0};
    const double distance = ring_radius + winding_radius * std::cos(ring_angle);
    const glm::dvec3 normal = std::cos(ring_angle) * radial + std::sin(ring_angle) * axis;
    const glm::dvec3 along_ring_turn = -std::sin(ring_angle) * radial + std::cos(ring_angle) * axis;
    const glm::dvec3 tangent = glm::normalize(around_axis * distance * along_axis_turn +
                                              around_ring * winding_radius * along_ring_turn);

    TubeSection section;
    section.center = ring_radius * radial + winding_radius * normal;
    section.right = normal;
    section.up = glm::cross(tangent, normal);
    return section;
}

} // namespace

Mesh torus_knot(int size) {
    const int section_count = 128 * size;
    std::vector<TubeSection> sections;
    sections.reserve(section_count);
    for (int i = 0; i < section_count; ++i) {
        sections.push_back(knot_section(static_cast<double>(i) / section_count));
    }
    return closed_tube(sections, tube_radius, 4 * size);
}

namespace {

std::size_t index_of(const HeightField& field, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(field.cells + 1) +
           static_cast<std::size_t>(column);
}

// Every cell as four: the old heights, means at the new crossings, and a random amount on these.
HeightField refine(const HeightField& coarse, RandomNumbers& random, float roughness) {
    HeightField fine;
    fine.cells = 2 * coarse.cells;
    for (int row = 0; row <= fine.cells; ++row) {
        for (int column = 0; column <= fine.cells; ++column) {
            const int left = column / 2;
            const int above = row / 2;
            const int right = left + column % 2;
            const int below = above + row % 2;
            const float mean =
                0.25f * (height_at(coarse, left, above) + height_at(coarse, right, above) +
                         height_at(coarse, left, below) + height_at(coarse, right, below));
            const bool is_new = column % 2 == 1 || row % 2 == 1;
            const float change = is_new ? roughness * (2.0f * random.unit() - 1.0f) : 0.0f;
            fine.heights.push_back(mean + change);
        }
    }
    return fine;
}

} // namespace

float height_at(const HeightField& field, int column, int row) {
    return field.heights[index_of(field, column, row)];
}

HeightField random_mountain(int depth, int seed) {
    RandomNumbers random(seed);
    HeightField field{1, {0.0f, 0.0f, 0.0f, 0.0f}};
    if (depth == 0) {
        return field;
    }
    // The summit stands in the middle.
    field = {2, {0.0f, 0.0f, 0.0f, 0.0f, 0.75f, 0.0f, 0.0f, 0.0f, 0.0f}};
    float roughness = 0.3f;
    for (int level = 1; level < depth; ++level) {
        field = refine(field, random, roughness);
        roughness *= 0.5f;
    }
    return field;
}

} // namespace raysteps
