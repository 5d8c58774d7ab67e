#include "image/color_space.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

float srgb_from_linear(float linear) {
    if (linear <= 0.0031308f) {
        return 12.92f * linear;
    }
    return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float srgb) {
    if (srgb <= 0.04045f) {
        return srgb / 12.92f;
    }
    return std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t encode_srgb(float linear) {
    if (std::isnan(linear)) {
        return 0;
    }
    const float srgb = srgb_from_linear(std::clamp(linear, 0.0f, 1.0f));
    return static_cast<std::uint8_t>(std::lround(255.0f * srgb));
}

float decode_srgb(std::uint8_t step) {
    return linear_from_srgb(static_cast<float>(step) / 255.0f);
}

} // namespace raysteps
