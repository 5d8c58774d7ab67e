#include "render/rays.h"

#include "basics/error.h"
#include "gpu/draw.h"
#include "scene/view.h"

#include <algorithm>
#include <bit>
#include <string>

namespace raysteps {

namespace {

// A list lies in blocks of 8 x 8 texels, along rows of so many texels. Small blocks, so that a few
// thousand rays still lie in as many of a rasterizer's tiles (Mesa's llvmpipe: 64 x 64, one a core)
// as there are columns of them.
constexpr int block_side = 8;
constexpr int texels_per_row = 1024;
constexpr std::size_t rays_per_block = block_side * block_side;

std::size_t texel_count(const Texture& texture) {
    return static_cast<std::size_t>(texture.width()) * static_cast<std::size_t>(texture.height());
}

void set_view(Program& program, const View& view) {
    program.set("view.eye", view.eye)
        .set("view.lower_left", view.lower_left)
        .set("view.right", view.right)
        .set("view.up", view.up);
}

std::vector<Hit> hits_in(std::span<const glm::uvec4> texels) {
    std::vector<Hit> hits(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) {
        hits[i].t = std::bit_cast<float>(texels[i].x);
        hits[i].u = std::bit_cast<float>(texels[i].y);
        hits[i].v = std::bit_cast<float>(texels[i].z);
        hits[i].triangle = std::bit_cast<int>(texels[i].w);
    }
    return hits;
}

} // namespace

RayTextures make_ray_textures(int width, int height) {
    return {Texture(TexelFormat::rgba32f, width, height),
            Texture(TexelFormat::rgba32f, width, height)};
}

std::size_t texel_of_listed_ray(std::size_t ray, int width) {
    const std::size_t block = ray / rays_per_block;
    const std::size_t blocks_per_row = static_cast<std::size_t>(width) / block_side;
    // Within its block, the bits of a ray's number take turns: x, y, x, y, x, y from the lowest.
    const std::size_t i = ray % rays_per_block;
    //# exercise 10.5: the place in a block
    const std::size_t column = (i & 1) | (i >> 1 & 2) | (i >> 2 & 4);
    const std::size_t row = (i >> 1 & 1) | (i >> 2 & 2) | (i >> 3 & 4);
    //# stub: const std::size_t column = i % block_side;
    //# stub: const std::size_t row = i / block_side;
    //# end
    return (block / blocks_per_row * block_side + row) * static_cast<std::size_t>(width) +
           block % blocks_per_row * block_side + column;
}

RayTextures upload_rays(std::span<const Ray> rays, ListLayout layout) {
    GLint tallest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &tallest);
    const std::size_t most =
        static_cast<std::size_t>(texels_per_row) * static_cast<std::size_t>(tallest);
    if (rays.size() > most) {
        throw InputError("There are " + std::to_string(rays.size()) +
                         " rays, but this machine's OpenGL takes " + std::to_string(most) +
                         " at once. Split the file of rays.");
    }
    constexpr int blocks_per_row = texels_per_row / block_side;
    const int blocks =
        std::max(1, static_cast<int>((rays.size() + rays_per_block - 1) / rays_per_block));
    const int width = block_side * std::min(blocks, blocks_per_row);
    const int height = block_side * ((blocks + blocks_per_row - 1) / blocks_per_row);
    RayTextures textures = make_ray_textures(width, height);

    const glm::vec4 empty_origin(0.0f, 0.0f, 0.0f, 0.0f);
    const glm::vec4 empty_direction(0.0f, 0.0f, 1.0f, -1.0f);
    std::vector<glm::vec4> origins(texel_count(textures.origins), empty_origin);
    std::vector<glm::vec4> directions(texel_count(textures.origins), empty_direction);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::size_t texel = layout == ListLayout::rows ? i : texel_of_listed_ray(i, width);
        origins[texel] = glm::vec4(rays[i].origin, rays[i].t_min);
        directions[texel] = glm::vec4(rays[i].direction, rays[i].t_max);
    }
    write_texels(textures.origins, origins);
    write_texels(textures.directions, directions);
    return textures;
}

std::vector<std::size_t> pixels_in_blocks(int width, int height) {
    const int columns = (width + block_side - 1) / block_side * block_side;
    const int rows = (height + block_side - 1) / block_side * block_side;
    const auto wide = static_cast<std::size_t>(columns);
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < wide * static_cast<std::size_t>(rows); ++i) {
        const std::size_t texel = texel_of_listed_ray(i, columns);
        if (texel % wide < static_cast<std::size_t>(width) &&
            texel / wide < static_cast<std::size_t>(height)) {
            pixels.push_back(texel / wide * static_cast<std::size_t>(width) + texel % wide);
        }
    }
    return pixels;
}

std::vector<glm::uvec4> read_list(const Texture& integers, std::size_t count) {
    const std::vector<glm::uvec4> texels = read_integers(integers);
    std::vector<glm::uvec4> list(count);
    for (std::size_t i = 0; i < count; ++i) {
        list[i] = texels[texel_of_listed_ray(i, integers.width())];
    }
    return list;
}

std::vector<Ray> read_rays(const RayTextures& textures, std::size_t count) {
    const std::vector<Ray> texels = read_rays(textures);
    std::vector<Ray> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
        rays[i] = texels[texel_of_listed_ray(i, textures.origins.width())];
    }
    return rays;
}

std::vector<Ray> read_rays(const RayTextures& textures) {
    const std::vector<glm::vec4> origins = read_floats(textures.origins);
    const std::vector<glm::vec4> directions = read_floats(textures.directions);
    std::vector<Ray> rays(origins.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin = glm::vec3(origins[i]);
        rays[i].t_min = origins[i].w;
        rays[i].direction = glm::vec3(directions[i]);
        rays[i].t_max = directions[i].w;
    }
    return rays;
}

std::vector<Hit> read_hits(const Texture& hits, std::size_t count) {
    return hits_in(read_list(hits, count));
}

std::vector<Hit> read_hits(const Texture& hits) {
    return hits_in(read_integers(hits));
}

RayTextures generate_rays(const Camera& camera, int width, int height, RayGeneration generation) {
    Program program(generation == RayGeneration::interpolated ? "pass/rays/interpolate_rays.frag"
                                                              : "pass/rays/compute_rays.frag");
    set_view(program, view_of(camera, static_cast<double>(width) / height));
    program.set("picture_size", glm::vec2(width, height));
    RayTextures rays = make_ray_textures(width, height);
    rays.coherence = Coherence::neighbours;
    const Shape shape =
        generation == RayGeneration::interpolated ? Shape::rectangle : Shape::triangle;
    draw(program, {.textures = {rays.origins, rays.directions}, .shape = shape});
    return rays;
}

} // namespace raysteps
