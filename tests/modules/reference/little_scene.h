#pragma once

#include "scene/scene.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <initializer_list>

namespace raysteps {

inline Material diffuse_material(const glm::vec3& color) {
    Material material;
    material.diffuse = color;
    return material;
}

inline Material shining_material(const glm::vec3& emission) {
    Material material;
    material.diffuse = glm::vec3(0.0f);
    material.emission = emission;
    return material;
}

inline Material mirror_material(const glm::vec3& specular) {
    Material material;
    material.diffuse = glm::vec3(0.0f);
    material.specular = specular;
    material.illumination_model = 3;
    return material;
}

// Corners with a normal of their own at each: where all three are equal the triangle looks flat.
inline void add_triangle(Scene& scene, std::initializer_list<glm::vec3> corners,
                         const glm::vec3& normal, const Material& material) {
    scene.corners.insert(scene.corners.end(), corners);
    scene.normals.insert(scene.normals.end(), 3, normal);
    scene.texture_coordinates.insert(scene.texture_coordinates.end(), 3, glm::vec2(0.0f));
    scene.triangle_materials.push_back(static_cast<int>(scene.materials.size()));
    scene.materials.push_back(material);
}

// A large triangle around (0, 0, z), parallel to the picture of a camera that looks along z.
inline void add_wall(Scene& scene, float z, const Material& material) {
    add_triangle(scene, {{-40, -40, z}, {40, -40, z}, {0, 80, z}}, {0, 0, 1}, material);
}

// The camera looks from (0, 0, 5) to the origin; the background is black.
inline Scene empty_scene() {
    Scene scene;
    scene.camera = {
        .eye = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_field_of_view = 40.0f};
    return scene;
}

} // namespace raysteps
