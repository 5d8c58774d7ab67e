#pragma once

#include "scene/material.h"

#include <glm/vec3.hpp>

#include <string>

namespace raysteps {

// A surface that only scatters light.
inline Material matte(const std::string& name, const glm::vec3& diffuse) {
    Material material;
    material.name = name;
    material.diffuse = diffuse;
    return material;
}

// A surface that also mirrors, with the specular colour (illumination model 3).
inline Material mirror(const std::string& name, const glm::vec3& diffuse,
                       const glm::vec3& specular) {
    Material material = matte(name, diffuse);
    material.specular = specular;
    material.shininess = 200.0f;
    material.illumination_model = 3;
    return material;
}

} // namespace raysteps
