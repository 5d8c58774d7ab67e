#pragma once

#include "scene/sample_materials.h"

namespace raysteps {

// Clear glass (illumination model 7) of that refractive index, with a highlight. Of light that goes
// through one unit of length of it, `kept` is left.
inline Material glass(const std::string& name, float index, const glm::vec3& kept) {
    Material material = matte(name, glm::vec3(0.0f));
    material.specular = glm::vec3(0.9f);
    material.shininess = 400.0f;
    material.refractive_index = index;
    material.transmission = kept;
    material.illumination_model = 7;
    return material;
}

// A matte surface with a highlight (illumination model 2).
inline Material glossy(const std::string& name, const glm::vec3& diffuse, float specular,
                       float shininess) {
    Material material = matte(name, diffuse);
    material.specular = glm::vec3(specular);
    material.shininess = shininess;
    material.illumination_model = 2;
    return material;
}

// A matte surface with a picture, which may be one made by code: `made:bricks`.
inline Material painted(const std::string& name, const std::string& picture) {
    Material material = matte(name, glm::vec3(1.0f));
    material.diffuse_map = picture;
    return material;
}

// A lamp that one sees.
inline Material glowing(const std::string& name, const glm::vec3& emission) {
    Material material = matte(name, glm::vec3(0.0f));
    material.emission = emission;
    return material;
}

} // namespace raysteps
