#pragma once

#include "basics/ray.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Rays of one kind at a mesh.
struct AimedFamily {
    std::string name;
    std::vector<Ray> rays;
};

// Families that find the faults of triangle tests; random rays are nearly blind for them. Three
// corners a triangle, one triangle at least. Origins lie in the box of the mesh, so mostly inside
// of a closed one, unless said otherwise; directions are not normalised.
//   random    in any direction
//   inside    at points of triangles
//   edge      at points of edges, as nearly as floats say them
//   vertex    at corners: corner minus origin, rounded once
//   axis      along an axis, with one coordinate of a corner: in planes of the mesh
//   grazing   at points of triangles, at an angle of about 1e-4 to them
//   leaving   from points of triangles, moved off as chapter 03 does, in any direction
//   far       at points of triangles, from ten thousand sizes away
std::vector<AimedFamily> aim_at(std::span<const glm::vec3> corners, std::size_t count, int seed);

} // namespace raysteps
