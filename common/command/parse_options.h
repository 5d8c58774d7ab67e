#pragma once

#include "gpu/context.h"
#include "scene/camera.h"

#include <string>

namespace raysteps {

struct PictureSize {
    int width;
    int height;
};

// `640x480`, or `512` for a square; each side from 1 to 16384. Throws InputError.
PictureSize parse_size(const std::string& text);

// 6, 7 or 10 numbers between commas: eye and target, the vertical field of view in degrees, and up;
// what is not given is the start's. Throws InputError where a number is not one, where eye and
// target are the same point, or where up is parallel to the line between them.
Camera parse_camera(const std::string& text, const Camera& start);

// auto, osmesa, egl or window. Throws InputError.
ContextKind parse_context(const std::string& text);

} // namespace raysteps
