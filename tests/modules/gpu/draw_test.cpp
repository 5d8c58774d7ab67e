#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "hit_texels.h"

using namespace raysteps;

namespace {

constexpr int width = 5;
constexpr int height = 3;
constexpr std::size_t pixel_count = std::size_t{width} * height;

// The pass add_surroundings, where every ray misses, writes weight * background.
class Surroundings {
public:
    Surroundings()
        : hits_(hit_texels(width, height, [](int, int) { return -1; })),
          weights_(TexelFormat::rgba32f, width, height),
          program_("pass/light/add_surroundings.frag") {
        write_texels(weights_, std::vector<glm::vec4>(pixel_count, glm::vec4(1.0f)));
        program_.set("hits", hits_)
            .set("weights", weights_)
            .set("triangle_materials", triangle_materials_)
            .set("materials", materials_);
    }
    const Program& of_color(const glm::vec3& color) { return program_.set("background", color); }

private:
    Texture hits_;
    Texture weights_;
    // Nothing is hit, but OpenGL wants a texture of the right kind for each sampler.
    BufferTexture triangle_materials_{std::span<const std::int32_t>()};
    BufferTexture materials_{std::span<const glm::vec4>()};
    Program program_;
};

} // namespace

TEST_CASE("added colors are the sums in single precision", "[gpu][draw]") {
    const auto context = make_context(ContextKind::automatic);
    Surroundings surroundings;
    const Texture target(TexelFormat::rgba32f, width, height);
    const glm::vec3 first(0.1f, 1e10f, 16777216.0f);
    const glm::vec3 second(0.2f, 1.0f, 1.0f);
    clear(target);
    draw(surroundings.of_color(first), {.textures = {target}, .blend = Blend::add});
    draw(surroundings.of_color(second), {.textures = {target}, .blend = Blend::add});
    for (const glm::vec4& texel : read_floats(target)) {
        CHECK(texel == glm::vec4(first + second, 0.0f));
    }
}

TEST_CASE("a color that replaces leaves nothing of what was there", "[gpu][draw]") {
    const auto context = make_context(ContextKind::automatic);
    Surroundings surroundings;
    const Texture target(TexelFormat::rgba32f, width, height);
    write_texels(target, std::vector<glm::vec4>(pixel_count, glm::vec4(7.0f)));
    draw(surroundings.of_color(glm::vec3(1.0f)), {.textures = {target}, .blend = Blend::add});
    draw(surroundings.of_color({0.25f, 0.5f, 1.0f}), {.textures = {target}});
    for (const glm::vec4& texel : read_floats(target)) {
        CHECK(texel == glm::vec4(0.25f, 0.5f, 1.0f, 0.0f));
    }
}

TEST_CASE("a pass writes each of its outputs into a texture of its own", "[gpu][draw]") {
    const auto context = make_context(ContextKind::automatic);
    Program program("pass/rays/compute_rays.frag");
    program.set("view.eye", glm::vec3(1.0f, 2.0f, 3.0f))
        .set("view.lower_left", glm::vec3(-1.0f, -2.0f, -4.0f))
        .set("view.right", glm::vec3(2.0f, 0.0f, 0.0f))
        .set("view.up", glm::vec3(0.0f, 4.0f, 0.0f))
        .set("picture_size", glm::vec2(2.0f, 2.0f));
    const Texture origins(TexelFormat::rgba32f, 2, 2);
    const Texture directions(TexelFormat::rgba32f, 2, 2);
    draw(program, {.textures = {origins, directions}});
    CHECK(read_floats(origins) == std::vector<glm::vec4>(4, {1.0f, 2.0f, 3.0f, 0.0f}));
    // The centres of the pixels are a quarter and three quarters of the way; the bottom row first.
    const float farthest = 3.402823466e+38f;
    CHECK(read_floats(directions) == std::vector<glm::vec4>{{-0.5f, -1.0f, -4.0f, farthest},
                                                            {0.5f, -1.0f, -4.0f, farthest},
                                                            {-0.5f, 1.0f, -4.0f, farthest},
                                                            {0.5f, 1.0f, -4.0f, farthest}});
}

TEST_CASE("a rectangle covers every pixel once", "[gpu][draw]") {
    const auto context = make_context(ContextKind::automatic);
    Surroundings surroundings;
    const Texture origins(TexelFormat::rgba32f, 31, 17);
    const Texture directions(TexelFormat::rgba32f, 31, 17);
    clear(origins);
    Program program("pass/rays/interpolate_rays.frag");
    program.set("view.eye", glm::vec3(1.0f));
    // Added, a pixel that is drawn twice would be 2.
    draw(program,
         {.textures = {origins, directions}, .blend = Blend::add, .shape = Shape::rectangle});
    for (const glm::vec4& texel : read_floats(origins)) {
        REQUIRE(texel == glm::vec4(1.0f, 1.0f, 1.0f, 0.0f));
    }
}
