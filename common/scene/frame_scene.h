#pragma once

#include "geometry/box.h"
#include "scene/scene.h"

namespace raysteps {

// The box around all corners of the scene; empty where it has no triangle.
Box bounds_of(const Scene& scene);

// A camera that sees the whole box, from above right, at the aspect ratio width / height.
Camera frame_box(const Box& box, float aspect_ratio);

} // namespace raysteps
