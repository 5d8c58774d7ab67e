#pragma once

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/sky.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// An OBJ file in a scene, and where it stands.
struct Model {
    std::string path;
    glm::mat4 transform{1.0f};
};

// Everything that a picture needs, in world space. Triangle i has the corners, normals and texture
// coordinates 3i, 3i + 1 and 3i + 2; triangles are numbered in the order of their file.
// Every number is finite, every material index is in range, and materials is never empty.
struct Scene {
    std::string name;
    std::vector<glm::vec3> corners;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texture_coordinates;
    std::vector<int> triangle_materials;
    std::vector<Material> materials;
    std::vector<Light> lights;
    Camera camera;
    glm::vec3 background{0.0f};
    std::optional<Sky> sky;            // where there is one, it takes the place of the background
    std::vector<Model> models;         // where the triangles came from; empty for a sample scene
    std::vector<std::string> messages; // what a person should know of how it was loaded
};

inline int triangle_count(const Scene& scene) {
    return static_cast<int>(scene.corners.size() / 3);
}

} // namespace raysteps
