#include "scene/pack_scene.h"

#include "scene/scene.h"

namespace raysteps {

std::vector<glm::vec4> pack_vectors(std::span<const glm::vec3> vectors) {
    std::vector<glm::vec4> texels;
    texels.reserve(vectors.size());
    for (const glm::vec3& vector : vectors) {
        texels.emplace_back(vector, 0.0f);
    }
    return texels;
}

std::vector<glm::vec4> pack_materials(std::span<const Material> materials) {
    std::vector<glm::vec4> texels;
    texels.reserve(3 * materials.size());
    for (const Material& material : materials) {
        texels.emplace_back(material.diffuse, 0.0f);
        texels.emplace_back(material.specular, is_mirror(material) ? 1.0f : 0.0f);
        texels.emplace_back(material.emission, 0.0f);
    }
    return texels;
}

std::vector<glm::vec4> pack_glass(const Scene& scene) {
    std::vector<glm::vec4> texels;
    texels.reserve(2 * scene.materials.size());
    for (const Material& material : scene.materials) {
        texels.emplace_back(material.transmission, material.refractive_index);
        texels.emplace_back(transparency(material), 0.0f, 0.0f, 0.0f);
    }
    return texels;
}

std::vector<glm::vec4> pack_gloss(const Scene& scene) {
    std::vector<glm::vec4> texels;
    texels.reserve(scene.materials.size());
    for (const Material& material : scene.materials) {
        texels.emplace_back(material.specular, has_highlight(material) ? material.shininess : 0.0f);
    }
    return texels;
}

} // namespace raysteps
