#pragma once

#include "effort.h"
#include "knob.h"
#include "scene/scene.h"

namespace raysteps {

// Choices that change the speed and the memory, and no answer: bins, leaf sizes, resolutions, the
// precision of nodes, room in the box test. The rays are the camera's and random ones; every hit
// must be that of bvh_ordered, bit for bit. A context must be current.
Knob speed_knob(const Scene& scene, const Effort& effort);

} // namespace raysteps
