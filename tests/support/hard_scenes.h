#pragma once

#include "hard_cases/meshes.h"
#include "scene/scene.h"

// Sizes and places at which the arithmetic of a structure can go wrong.
namespace raysteps {

inline Scene moved(Scene scene, float scale, const glm::vec3& offset) {
    scene.corners = scaled_and_moved({scene.corners, {}}, scale, offset).corners;
    return scene;
}

// All triangles in one plane, at that place of the axis.
inline Scene flattened(Scene scene, int axis, float place) {
    scene.corners = flattened(Mesh{scene.corners, {}}, axis, place).corners;
    return scene;
}

} // namespace raysteps
