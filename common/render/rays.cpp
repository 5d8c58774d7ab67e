#include "render/rays.h"

#include "basics/error.h"
#include "gpu/draw.h"
#include "scene/view.h"

#include <algorithm>
#include <bit>
#include <string>

namespace raysteps {

namespace {

constexpr int rays_per_row = 1024;

std::size_t texel_count(const Texture& texture) {
    return static_cast<std::size_t>(texture.width()) * static_cast<std::size_t>(texture.height());
}

void set_view(Program& program, const View& view) {
    program.set("view.eye", view.eye)
        .set("view.lower_left", view.lower_left)
        .set("view.right", view.right)
        .set("view.up", view.up);
}

} // namespace

RayTextures make_ray_textures(int width, int height) {
    return {Texture(TexelFormat::rgba32f, width, height),
            Texture(TexelFormat::rgba32f, width, height)};
}

RayTextures upload_rays(std::span<const Ray> rays) {
    GLint tallest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &tallest);
    const std::size_t most =
        static_cast<std::size_t>(rays_per_row) * static_cast<std::size_t>(tallest);
    if (rays.size() > most) {
        throw InputError("There are " + std::to_string(rays.size()) +
                         " rays, but this machine's OpenGL takes " + std::to_string(most) +
                         " at once. Split the file of rays.");
    }
    const int count = static_cast<int>(rays.size());
    const int width = std::clamp(count, 1, rays_per_row);
    const int height = std::max(1, (count + width - 1) / width);
    RayTextures textures = make_ray_textures(width, height);

    const glm::vec4 empty_origin(0.0f, 0.0f, 0.0f, 0.0f);
    const glm::vec4 empty_direction(0.0f, 0.0f, 1.0f, -1.0f);
    std::vector<glm::vec4> origins(texel_count(textures.origins), empty_origin);
    std::vector<glm::vec4> directions(texel_count(textures.origins), empty_direction);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        origins[i] = glm::vec4(rays[i].origin, rays[i].t_min);
        directions[i] = glm::vec4(rays[i].direction, rays[i].t_max);
    }
    write_texels(textures.origins, origins);
    write_texels(textures.directions, directions);
    return textures;
}

std::vector<Ray> read_rays(const RayTextures& textures, std::size_t count) {
    const std::vector<glm::vec4> origins = read_floats(textures.origins);
    const std::vector<glm::vec4> directions = read_floats(textures.directions);
    std::vector<Ray> rays(count);
    for (std::size_t i = 0; i < count; ++i) {
        rays[i].origin = glm::vec3(origins[i]);
        rays[i].t_min = origins[i].w;
        rays[i].direction = glm::vec3(directions[i]);
        rays[i].t_max = directions[i].w;
    }
    return rays;
}

std::vector<Ray> read_rays(const RayTextures& textures) {
    return read_rays(textures, texel_count(textures.origins));
}

std::vector<Hit> read_hits(const Texture& hits, std::size_t count) {
    const std::vector<glm::uvec4> texels = read_integers(hits);
    std::vector<Hit> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        result[i].t = std::bit_cast<float>(texels[i].x);
        result[i].u = std::bit_cast<float>(texels[i].y);
        result[i].v = std::bit_cast<float>(texels[i].z);
        result[i].triangle = std::bit_cast<int>(texels[i].w);
    }
    return result;
}

std::vector<Hit> read_hits(const Texture& hits) {
    return read_hits(hits, texel_count(hits));
}

RayTextures generate_rays(const Camera& camera, int width, int height, RayGeneration generation) {
    Program program(generation == RayGeneration::interpolated ? "pass/rays/interpolate_rays.frag"
                                                              : "pass/rays/compute_rays.frag");
    set_view(program, view_of(camera, static_cast<double>(width) / height));
    program.set("picture_size", glm::vec2(width, height));
    RayTextures rays = make_ray_textures(width, height);
    const Shape shape =
        generation == RayGeneration::interpolated ? Shape::rectangle : Shape::triangle;
    draw(program, {.textures = {rays.origins, rays.directions}, .shape = shape});
    return rays;
}

} // namespace raysteps
