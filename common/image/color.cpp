#include "image/color.h"

#include "image/image.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

namespace {

// Every 17th of viridis's 256 entries, in sRGB steps.
constexpr std::array<glm::vec3, 16> viridis = {{
    {68, 1, 84},
    {72, 26, 108},
    {71, 47, 125},
    {65, 68, 135},
    {57, 86, 140},
    {49, 104, 142},
    {42, 120, 142},
    {35, 136, 142},
    {31, 152, 139},
    {34, 168, 132},
    {53, 183, 121},
    {84, 197, 104},
    {122, 209, 81},
    {165, 219, 54},
    {210, 226, 27},
    {253, 231, 37},
}};

} // namespace

glm::vec3 color_map(float value) {
    if (std::isnan(value)) {
        return nan_color;
    }
    const float position = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(viridis.size() - 1);
    const std::size_t entry = std::min(static_cast<std::size_t>(position), viridis.size() - 2);
    const float between = position - static_cast<float>(entry);
    const glm::vec3 srgb = glm::mix(viridis[entry], viridis[entry + 1], between) / 255.0f;
    return {linear_from_srgb(srgb.x), linear_from_srgb(srgb.y), linear_from_srgb(srgb.z)};
}

} // namespace raysteps
