#pragma once

#include "basics/ray.h"
#include "gpu/texture.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace raysteps {

// Whether the rays of neighbouring texels go much the same way, as those of a camera do, and those
// from neighbouring points to a light; or each its own way, as rays that bounce do. It decides how
// they are traced, never what they hit.
enum class Coherence { alone, neighbours };

// One ray per texel: origins hold the origin and t_min, directions the direction and t_max.
struct RayTextures {
    Texture origins;
    Texture directions;
    Coherence coherence = Coherence::alone;
};

RayTextures make_ray_textures(int width, int height);

// A list of any number of rays; texels left over hold empty rays. Where neighbours in the list are
// neighbours in space, those of the textures are too: 4 rays lie in a square of 2 x 2 texels, 16 in
// one of 4 x 4, and 64 in one of 8 x 8. So those that a processor traces side by side go the same
// way. Source of the curve: Morton, "A Computer Oriented Geodetic Data Base", 1966.
//
// Or row by row, as one writes a list down: then the ray of that number lies in that texel. Chapter
// 10 measures what blocks are worth.
enum class ListLayout { blocks, rows };
RayTextures upload_rays(std::span<const Ray> rays, ListLayout layout = ListLayout::blocks);

// Where the ray of that number in a list of blocks lies: row times width and column. All that read
// such a list's texels ask here.
std::size_t texel_of_listed_ray(std::size_t ray, int width);

// What a texture of the size of a list's textures holds for its first `count` rays.
std::vector<glm::uvec4> read_list(const Texture& integers, std::size_t count);

// The pixels of a picture, row times width and column each, in the order in which a list of their
// rays has to be for neighbours to stay neighbours: block by block, and in each as in a list.
std::vector<std::size_t> pixels_in_blocks(int width, int height);

// The first `count` rays of a list, and their hits.
std::vector<Ray> read_rays(const RayTextures& textures, std::size_t count);
std::vector<Hit> read_hits(const Texture& hits, std::size_t count);

// All rays of a picture, and their hits, the bottom row first.
std::vector<Ray> read_rays(const RayTextures& textures);
std::vector<Hit> read_hits(const Texture& hits);

// How a pixel gets the direction of its ray.
enum class RayGeneration {
    interpolated, // between the four corner rays, by the rasterizer, as in the paper
    direct,       // computed from the position of the pixel
};

// One ray through the centre of each pixel, the bottom row first. They are neighbours.
RayTextures generate_rays(const Camera& camera, int width, int height, RayGeneration generation);

} // namespace raysteps
