#pragma once

#include "gpu/context.h"
#include "render/whitted_renderer.h"

namespace raysteps {

// The picture of a scene by the wavefront on the GPU. A context must be current.
inline Image whitted_by_gpu(const Scene& scene, int width, int height, int max_bounces) {
    WhittedRenderer renderer(scene, upload(scene), {{"triangle", "triangle/watertight.glsl"}},
                             measure_limits());
    return renderer.render(scene.camera, width, height, max_bounces);
}

} // namespace raysteps
