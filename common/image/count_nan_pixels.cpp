#include "image/count_nan_pixels.h"

#include <algorithm>
#include <cmath>

namespace raysteps {

bool has_nan(const glm::vec3& pixel) {
    return std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z);
}

std::size_t count_nan_pixels(const Image& image) {
    return static_cast<std::size_t>(
        std::count_if(image.pixels.begin(), image.pixels.end(), has_nan));
}

} // namespace raysteps
