#pragma once

#include "basics/ray.h"
#include "gpu/texture.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace raysteps {

// One ray per texel: origins hold the origin and t_min, directions the direction and t_max.
struct RayTextures {
    Texture origins;
    Texture directions;
};

RayTextures make_ray_textures(int width, int height);

// Any number of rays, in rows; texels left over hold empty rays.
RayTextures upload_rays(std::span<const Ray> rays);

// The first `count` rays, the bottom row of the textures first.
std::vector<Ray> read_rays(const RayTextures& textures, std::size_t count);
std::vector<Ray> read_rays(const RayTextures& textures);

// The first `count` hits of a texture of hits, the bottom row first.
std::vector<Hit> read_hits(const Texture& hits, std::size_t count);
std::vector<Hit> read_hits(const Texture& hits);

// How a pixel gets the direction of its ray.
enum class RayGeneration {
    interpolated, // between the four corner rays, by the rasterizer, as in the paper
    direct,       // computed from the position of the pixel
};

// One ray through the centre of each pixel, the bottom row first.
RayTextures generate_rays(const Camera& camera, int width, int height, RayGeneration generation);

} // namespace raysteps
