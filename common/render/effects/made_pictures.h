#pragma once

#include "image/image.h"

#include <string>

namespace raysteps {

// A picture made by code, for surfaces of sample scenes: `made:checker`, `made:bricks`, `made:wood`
// or `made:globe`. Throws InputError where there is none of that name.
Image made_picture(const std::string& name);

// Whether the name is one that made_picture is asked for.
bool is_made_picture(const std::string& name);

} // namespace raysteps
