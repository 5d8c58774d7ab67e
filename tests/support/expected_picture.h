#pragma once

#include "image/color.h"
#include "image/image_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace raysteps {

// How many pixels of the image are not those of the file: a component of its 8 bits may be one step
// off, where another driver rounds the other way.
inline std::size_t pixels_unlike(const Image& image, const std::filesystem::path& file) {
    const Image expected = read_picture(std::filesystem::path(RAYSTEPS_SOURCE_DIR) / file);
    if (expected.width != image.width || expected.height != image.height) {
        return image.pixels.size();
    }
    std::size_t unexpected = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        int farthest = 0;
        for (int c = 0; c < 3; ++c) {
            farthest = std::max(farthest, std::abs(encode_srgb(image.pixels[i][c]) -
                                                   encode_srgb(expected.pixels[i][c])));
        }
        unexpected += farthest > 1 ? 1 : 0;
    }
    return unexpected;
}

// The same against chapters/CHAPTER/expected.png.
inline std::size_t unexpected_pixels(const Image& image, const std::string& chapter) {
    return pixels_unlike(image, std::filesystem::path("chapters") / chapter / "expected.png");
}

} // namespace raysteps
