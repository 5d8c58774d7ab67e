#pragma once

#include "scene/material.h"

namespace raysteps {

// What a material calls for, by the statements of its MTL file.

// The part of the light that a surface lets through: 1 - d where d is under 1; else all of it where
// the illumination model asks for transparency (4, 6, 7 and 9), and nothing where it does not.
float transparency(const Material& material);

inline bool is_glass(const Material& material) {
    return transparency(material) > 0.0f;
}

// Does it swallow light on the way through (Tf)?
inline bool absorbs(const Material& material) {
    return is_glass(material) && material.transmission != glm::vec3(1.0f);
}

// The illumination models from 2 on ask for highlights; without a colour or an exponent they are
// none.
inline bool has_highlight(const Material& material) {
    return material.illumination_model >= 2 && material.specular != glm::vec3(0.0f) &&
           material.shininess > 0.0f;
}

inline bool has_picture(const Material& material) {
    return !material.diffuse_map.empty();
}

} // namespace raysteps
