#pragma once

#include <string>

namespace raysteps {

struct PictureSize {
    int width;
    int height;
};

// `640x480`, or `512` for a square; each side from 1 to 16384. Throws InputError.
PictureSize parse_size(const std::string& text);

} // namespace raysteps
