#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <span>
#include <vector>

namespace raysteps {

// Cuts a counter-clockwise polygon of at least three points into n - 2 triangles by cutting off
// ears (Meisters, "Polygons have ears", American Mathematical Monthly, 1975): corners whose
// triangle holds no other corner. Where edges cross there may be none; then any corner is cut off,
// so that it ends.
std::vector<std::array<int, 3>> cut_ears(std::span<const glm::dvec2> points);

} // namespace raysteps
