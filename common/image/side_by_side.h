#pragma once

#include "image/image.h"

#include <span>
#include <string>

namespace raysteps {

// The pictures from left to right, a thin white gap between them, each with its caption below it.
// A caption wraps at the width of its picture. Throws InputError where there is no picture, where
// their heights differ, or where there is not one caption for each.
Image side_by_side(std::span<const Image> images, std::span<const std::string> captions);

} // namespace raysteps
