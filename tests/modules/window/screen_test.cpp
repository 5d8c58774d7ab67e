#include "program/window/screen.h"

#include "catch.h"
#include "gpu/context.h"
#include "gpu/draw.h"
#include "image/color.h"
#include "image/image.h"
#include "program/window/screen.h"

#include <glm/geometric.hpp>

#include <limits>

using namespace raysteps;

namespace {

// Half of a screen's step: nearer than that, at most neighbouring steps are shown.
constexpr float half_step = 0.5f / 255.0f;

// What the window's pass draws, bottom row first.
std::vector<glm::vec4> shown(const Image& image, int width, int height) {
    const Texture picture = screen_texture(image);
    const Texture target(TexelFormat::rgba32f, width, height);
    Program program("pass/show/show_image.frag");
    program.set("picture", picture).set("size", glm::vec2(width, height));
    draw(program, {.textures = {target}});
    return read_floats(target);
}

} // namespace

TEST_CASE("a picture is shown in sRGB with its top row above", "[window]") {
    const auto context = make_context(ContextKind::automatic);
    Image image(64, 3);
    for (int column = 0; column < 64; ++column) {
        image.at(column, 0) = glm::vec3(static_cast<float>(column) / 63.0f);
        image.at(column, 1) = {0.001f * static_cast<float>(column), 0.0f, 1.0f};
    }
    const std::vector<glm::vec4> pixels = shown(image, 64, 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int column = static_cast<int>(i % 64);
        const int row = 2 - static_cast<int>(i / 64);
        CAPTURE(column, row);
        const glm::vec3& linear = image.at(column, row);
        for (int channel = 0; channel < 3; ++channel) {
            CHECK(std::abs(pixels[i][channel] - srgb_from_linear(linear[channel])) <= half_step);
        }
        CHECK(pixels[i].w == 1.0f);
    }
}

TEST_CASE("a coarse picture is magnified smoothly", "[window]") {
    const auto context = make_context(ContextKind::automatic);
    Image image(2, 1);
    image.at(1, 0) = glm::vec3(1.0f);
    const std::vector<glm::vec4> pixels = shown(image, 4, 1);
    // The pixels' centres lie at 0.25, 0.75, 1.25 and 1.75 texels; the texels' at 0.5 and 1.5.
    const float expected[4] = {0.0f, 0.25f, 0.75f, 1.0f};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(std::abs(pixels[i].x - srgb_from_linear(expected[i])) <= half_step);
    }
}

TEST_CASE("what a screen cannot show becomes what a PNG file has", "[window]") {
    const auto context = make_context(ContextKind::automatic);
    const float infinity = std::numeric_limits<float>::infinity();
    Image image(2, 1);
    image.at(0, 0) = {infinity, -infinity, 7.0f};
    image.at(1, 0) = {0.5f, std::numeric_limits<float>::quiet_NaN(), 0.5f};
    const std::vector<glm::vec4> texels = read_floats(screen_texture(image));
    CHECK(texels[0] == glm::vec4(1.0f, 0.0f, 1.0f, 1.0f));
    CHECK(texels[1] == glm::vec4(nan_color, 1.0f));
}
