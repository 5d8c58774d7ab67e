#include "scene/torus_knot.h"

#include "scene/tube.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace raysteps {

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
    sections.reserve(static_cast<std::size_t>(section_count));
    for (int i = 0; i < section_count; ++i) {
        sections.push_back(knot_section(static_cast<double>(i) / section_count));
    }
    return closed_tube(sections, tube_radius, 4 * size);
}

} // namespace raysteps
