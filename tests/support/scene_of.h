#pragma once

#include "scene/mesh.h"
#include "scene/scene.h"

#include <vector>

namespace raysteps {

// A scene of one mesh in grey.
inline Scene scene_of(const Mesh& mesh) {
    return add_mesh(Scene{}, mesh, Material{});
}

// The same of three corners a triangle; nothing looks at its normals.
inline Scene scene_of_corners(const std::vector<glm::vec3>& corners) {
    Mesh mesh;
    mesh.corners = corners;
    mesh.normals.resize(corners.size(), {0.0f, 0.0f, 1.0f});
    return scene_of(mesh);
}

} // namespace raysteps
