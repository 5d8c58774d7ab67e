#pragma once

#include "mirror/mirror_scene.h"
#include "visualizer/replay/walk_recorder.h"

#include <cstddef>
#include <span>
#include <string>

namespace raysteps::view {

// One of a hard case's rays, and which usual method it breaks, in words.
struct HardRay {
    std::size_t number = 0;
    std::string why;
};

// The first ray that breaks a usual method: a walk that takes a hit beyond the cell where it finds
// it for the answer; or the triangle test by Moeller and Trumbore, where that is not too much work
// (triangle/moeller_trumbore.glsl). Where none does, the first that hits anything, else
// the first. There has to be one.
HardRay choose_hard_ray(std::span<const Ray> rays, const mirror::SceneBuffers& scene,
                        const WalkRecorder& recorder);

} // namespace raysteps::view
