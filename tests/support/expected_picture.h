#pragma once

#include "image/difference.h"
#include "image/write_png.h"

#include <filesystem>
#include <string>

namespace raysteps {

// How many pixels of the image are not those of chapters/CHAPTER/expected.png. A file has 8 bits a
// component, so half a step of it is no difference: near white, where steps are largest in linear
// light, a step is 0.0089 wide. One step more is left to the driver's pow().
inline std::size_t unexpected_pixels(const Image& image, const std::string& chapter) {
    const auto path =
        std::filesystem::path(RAYSTEPS_SOURCE_DIR) / "chapters" / chapter / "expected.png";
    return difference(image, read_png(path), 1.5f * 0.0089f).different_pixels;
}

} // namespace raysteps
