#pragma once

#include "image/image.h"

#include <rapidcheck.h>

#include <limits>

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// A picture of up to 8 x 8 pixels whose components are drawn from the generator.
inline raysteps::Image random_image(const rc::Gen<float>& component) {
    raysteps::Image image(*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9));
    for (glm::vec3& pixel : image.pixels) {
        pixel = {*component, *component, *component};
    }
    return image;
}
