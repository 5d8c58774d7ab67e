#pragma once

#include "scene/camera.h"

#include <string>

namespace raysteps {

// 6, 7 or 10 numbers between commas: eye and target, the vertical field of view in degrees, and up;
// what is not given is the start's. Throws InputError where a number is not one, where eye and
// target are the same point, or where up is parallel to the line between them.
Camera parse_camera(const std::string& text, const Camera& start);

} // namespace raysteps
