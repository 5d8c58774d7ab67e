#pragma once

#include "geometry/layout.h"
#include "scene/camera.h"

namespace raysteps {

// The rectangle that the camera looks through at this aspect ratio (width / height), computed in
// double and rounded once.
View view_of(const Camera& camera, double aspect_ratio);

} // namespace raysteps
