#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace raysteps {

// The polygon seen along the axis that its mean normal is nearest to (Newell's method: Sutherland,
// Sproull and Schumacker, "A Characterization of Ten Hidden-Surface Algorithms", 1974), from the
// side where it runs counter-clockwise. Seen so, triangles keep their order of corners and their
// overlaps.
std::vector<glm::dvec2> flatten_polygon(std::span<const glm::vec3> corners);

// Twice the signed area of the triangle: positive where it turns counter-clockwise.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

} // namespace raysteps
