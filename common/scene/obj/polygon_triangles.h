#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace raysteps {

// Corners of a polygon, by their place in it.
using PolygonTriangle = std::array<int, 3>;

// Cuts a polygon of n corners in space into at most n - 2 triangles with an area, which turn as it
// does. A fan around corner 0 where that covers the polygon, as it does where it is convex; else
// ears are cut off (Meisters, "Polygons have ears", 1975), seen along the polygon's mean normal.
// Where the edges cross, no answer is right: the triangles are then what cutting ears leaves.
// Time is about n^1.5 in polygons without crossings, and limited to a multiple of it in all.
std::vector<PolygonTriangle> triangulate_polygon(std::span<const glm::vec3> corners);

} // namespace raysteps
