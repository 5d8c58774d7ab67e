#include "catch.h"
#include "effect_pictures.h"
#include "image/image_file.h"
#include "mirror/effects.h"
#include "mirror/mirror_scene.h"
#include "render/effects/effect_buffers.h"
#include "support/error_of.h"
#include "support/scratch_folder.h"

#include <cmath>

using namespace raysteps;

namespace {

using PictureParts = mirror::EffectParts<double>;

// The texels of one picture of four grey values: 0.1 and 0.2 above, 0.3 and 0.4 below.
struct SmallPicture {
    SmallPicture() {
        for (const float grey : {0.1f, 0.2f, 0.3f, 0.4f, 0.25f}) {
            texels.emplace_back(grey, grey, grey, 0.0f);
        }
        parts.picture_texels.texels = texels;
    }

    std::vector<glm::vec4> texels; // the last one is level 1
    PictureParts parts{};
    PictureParts::Picture picture{0, 2, 2, 2};
};

// A wall with a picture over the part of it that the camera sees, and a light straight before it.
Scene painted_wall(const std::string& picture, float repeats) {
    Material material;
    material.name = "painted";
    material.diffuse = glm::vec3(1.0f);
    material.diffuse_map = picture;
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 1.0f), material);
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        scene.texture_coordinates[i] =
            repeats * 0.5f * (glm::vec2(scene.corners[i]) + glm::vec2(1.0f));
    }
    scene.lights = {{{0, 0, 1000}, glm::vec3(1.0f)}};
    return scene;
}

} // namespace

TEST_CASE("a mipmap keeps the mean of its image and ends with one texel", "[09][textures]") {
    Image picture(8, 4);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = glm::vec3(static_cast<float>(i));
    }
    const std::vector<Image> levels = mipmap_of(picture);
    REQUIRE(levels.size() == 4);
    CHECK(levels[1].width == 4);
    CHECK(levels[1].height == 2);
    CHECK(levels[1].at(0, 0).x == (0 + 1 + 8 + 9) / 4.0f);
    CHECK(levels[2].height == 1);
    CHECK(levels[3].pixels.size() == 1);
    CHECK(levels[3].at(0, 0).x == 15.5f);
    CHECK(mipmap_of(Image(5, 3)).size() == 3);
}

TEST_CASE("between texels colours mix and at their centres they are alone", "[09][textures]") {
    SmallPicture small;
    const auto grey = [&](double level, double u, double v) {
        return small.parts.picture_color(small.picture, level, u, v).x;
    };
    CHECK(grey(0.0, 0.25, 0.75) == Approx(0.1f));
    CHECK(grey(0.0, 0.75, 0.75) == Approx(0.2f));
    CHECK(grey(0.0, 0.25, 0.25) == Approx(0.3f));
    CHECK(grey(0.0, 0.5, 0.5) == Approx(0.25f));
    CHECK(grey(0.0, 0.0, 0.75) == Approx(0.15f)); // half of what stands at the other edge
    CHECK(grey(1.0, 0.25, 0.75) == Approx(0.25f));
    CHECK(grey(0.5, 0.25, 0.75) == Approx(0.5 * 0.1 + 0.5 * 0.25));
    CHECK(grey(99.0, 0.25, 0.75) == Approx(0.25f));
    CHECK(grey(-99.0, 0.25, 0.75) == Approx(0.1f));
}

TEST_CASE("a surface shows its texture upright", "[09][textures]") {
    const auto context = make_context(ContextKind::automatic);
    const ScratchFolder folder("09_pictures");
    Image picture(2, 2);
    picture.at(0, 0) = {1, 0, 0};
    picture.at(1, 0) = {0, 1, 0};
    picture.at(0, 1) = {0, 0, 1};
    picture.at(1, 1) = {1, 1, 1};
    write_png(folder / "picture.png", picture);
    const Scene scene = painted_wall((folder / "picture.png").string(), 1.0f);
    // The view is 1.41 of the picture's 2 wide: a pixel near its corner mixes 7 % of the texel
    // beside it and 7 % of that above or below into its own.
    const Image image = effect_picture(scene, 16).image;
    CHECK(image.at(1, 1).x > 0.8f);
    CHECK(image.at(1, 1).y < 0.2f);
    CHECK(image.at(14, 1).y > 0.8f);
    CHECK(image.at(14, 1).x < 0.2f);
    CHECK(image.at(1, 14).z > 0.8f);
    CHECK(image.at(14, 14).x > 0.8f);
    CHECK(effect_picture(scene, 1, "-textures").image.at(0, 0).x == Approx(1.0f).epsilon(1e-4));
}

TEST_CASE("far away a texture shows its mean and no noise", "[09][textures]") {
    const auto context = make_context(ContextKind::automatic);
    // 64 checkers of 8 by 8 squares across the wall: many squares a pixel.
    const Image image = effect_picture(painted_wall("made:checker", 64.0f), 16).image;
    double mean = 0.0;
    const Image checker = made_texture("made:checker");
    for (const glm::vec3& pixel : checker.pixels) {
        mean += static_cast<double>(pixel.x) / static_cast<double>(checker.pixels.size());
    }
    for (const glm::vec3& pixel : image.pixels) {
        CHECK(pixel.x == Approx(mean).epsilon(0.02)); // between levels of a square and coarser ones
    }
}

TEST_CASE("a texture that is missing is named and its material shows its colour",
          "[09][textures]") {
    const Scene scene = painted_wall("nowhere/picture.png", 1.0f);
    const LoadedTextures pictures = load_textures(scene, {Effect::textures});
    REQUIRE(pictures.messages.size() == 1);
    CHECK_THAT(pictures.messages[0], contains_text("Material painted: its texture is left out."));
    CHECK(pictures.textures == std::vector<int>{-1});
    CHECK_THAT(error_of([] { made_texture("made:fog"); }), contains_text("made:checker"));
    const auto context = make_context(ContextKind::automatic);
    CHECK(effect_picture(scene, 1).image.at(0, 0).x == Approx(1.0f).epsilon(1e-4));
}
