#pragma once

#include "scene/scene.h"

#include <glm/vec3.hpp>

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

} // namespace raysteps
