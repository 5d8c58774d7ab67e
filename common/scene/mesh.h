#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace raysteps {

// Triangles of one material: triangle i has the corners and normals 3i, 3i + 1 and 3i + 2, counter-
// clockwise as seen from outside. Equal corners have equal bits, so a closed mesh has no gap.
struct Mesh {
    std::vector<glm::vec3> corners;
    std::vector<glm::vec3> normals; // of length 1
};

// Both meshes, the first one first.
Mesh join(Mesh first, const Mesh& second);

// The scene with the mesh behind its triangles and the material behind its materials.
Scene add_mesh(Scene scene, const Mesh& mesh, const Material& material);

inline constexpr std::int64_t flat = -1;

// Twice the area of the triangle a, b, c is the length of this vector, which stands upright on it
// on the side where the corners run counter-clockwise. In double, because the squares and products
// of coordinates up to 1.8e18 overflow a float.
glm::dvec3 area_vector(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

// The normal of unit length at each corner; corners 3i, 3i + 1 and 3i + 2 are a triangle. Corners
// with the same surface get one normal: those of their triangles, weighted by the angles there
// (Thuermer and Wuethrich, "Computing Vertex Normals from Polygonal Facets", 1998). Where these
// cancel out, and where the surface is `flat`, it is the triangle's own. A triangle without area
// has none: each of its corners takes the mean of the triangles with an area that meet there, and
// where there is no such triangle, or they cancel out, any direction across the longest edge.
// Without surfaces all are flat.
std::vector<glm::vec3> corner_normals(std::span<const glm::vec3> corners,
                                      std::span<const std::int64_t> surfaces);

} // namespace raysteps
