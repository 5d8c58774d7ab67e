#pragma once

#include "render/ray_textures.h"
#include "scene/camera.h"

namespace raysteps {

// How a pixel gets the direction of its ray.
enum class RayGeneration {
    interpolated, // between the four corner rays, by the rasterizer, as in the paper
    direct,       // computed from the place of the pixel
};

// One ray through the centre of each pixel, the bottom row first.
RayTextures generate_rays(const Camera& camera, int width, int height, RayGeneration generation);

} // namespace raysteps
