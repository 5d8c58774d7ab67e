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

// `ex,ey,ez,tx,ty,tz` or `ex,ey,ez,tx,ty,tz,angle`: eye, target and the vertical field of view in
// degrees; what is not given is the start's. Throws InputError where a number is not one, or where
// eye and target are the same point.
Camera parse_camera(const std::string& text, const Camera& start);

// auto, osmesa, egl or window. Throws InputError.
ContextKind parse_context(const std::string& text);

} // namespace raysteps
