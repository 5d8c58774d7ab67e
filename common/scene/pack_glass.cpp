#include "scene/pack_glass.h"

#include "scene/material_effects.h"

namespace raysteps {

std::vector<glm::vec4> pack_glass(const Scene& scene) {
    std::vector<glm::vec4> texels;
    texels.reserve(2 * scene.materials.size());
    for (const Material& material : scene.materials) {
        texels.emplace_back(material.transmission, material.refractive_index);
        texels.emplace_back(transparency(material), 0.0f, 0.0f, 0.0f);
    }
    return texels;
}

} // namespace raysteps
