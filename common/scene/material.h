#pragma once

#include <glm/vec3.hpp>

#include <string>

namespace raysteps {

// What an MTL file says of a surface; the letters are the file's own (Wavefront, "MTL material
// format", 1995). Colours are linear RGB.
struct Material {
    std::string name = "default";
    glm::vec3 diffuse{0.8f};       // Kd
    glm::vec3 specular{0.0f};      // Ks: also the colour of a mirror
    float shininess = 0.0f;        // Ns
    glm::vec3 emission{0.0f};      // Ke
    float refractive_index = 1.0f; // Ni
    float opacity = 1.0f;          // d, or 1 - Tr
    glm::vec3 transmission{1.0f};  // Tf
    int illumination_model = 1;    // illum
    std::string diffuse_map;       // map_Kd: path of the picture, empty where there is none
};

// The illumination models 3 to 7 and 9 ask for ray-traced reflection; without a specular colour it
// is black.
inline bool is_mirror(const Material& material) {
    const int model = material.illumination_model;
    return ((model >= 3 && model <= 7) || model == 9) && material.specular != glm::vec3(0.0f);
}

} // namespace raysteps
