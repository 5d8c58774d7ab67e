#include "catch.h"
#include "effect_pictures.h"
#include "image/color.h"
#include "image/image_file.h"
#include "render/effects/effect_buffers.h"
#include "support/scratch_folder.h"

#include <glm/geometric.hpp>

using namespace raysteps;

namespace {

// A picture file of one colour, given as the three bytes of its file.
class PlainPicture {
public:
    explicit PlainPicture(const glm::ivec3& bytes) {
        Image image(2, 2);
        for (glm::vec3& pixel : image.pixels) {
            for (int i = 0; i < 3; ++i) {
                pixel[i] = decode_srgb(static_cast<std::uint8_t>(bytes[i]));
            }
        }
        write_png(folder_ / "plain.png", image);
    }

    std::string path() const { return (folder_ / "plain.png").string(); }

private:
    ScratchFolder folder_{"surface_map"};
};

// A white wall at z = 0, whose texture has u to the right and v upwards, under a light that is far
// away in that direction.
Scene mapped_wall(const Material& material, const glm::vec3& to_light) {
    Scene scene = add_mesh(white_scene(), facing_wall(0.0f, 1.0f), material);
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        scene.texture_coordinates[i] = 0.5f * (glm::vec2(scene.corners[i]) + glm::vec2(1.0f));
    }
    scene.lights = {{1e6f * to_light, glm::vec3(1.0f)}};
    return scene;
}

Material white() {
    Material material;
    material.name = "white";
    material.diffuse = glm::vec3(1.0f);
    return material;
}

Material with_normal_map(const PlainPicture& picture) {
    Material material = white();
    material.normal_map = picture.path();
    return material;
}

// What 8 bits say of a part of a normal.
float part(int byte) {
    return 2.0f * static_cast<float>(byte) / 255.0f - 1.0f;
}

float brightness(const Scene& scene, const std::string& choice = "") {
    return effect_picture(scene, 1, choice).image.at(0, 0).x;
}

} // namespace

TEST_CASE("a normal map bends the normal along the texture whatever side is seen",
          "[09][normal_maps]") {
    const auto context = make_context(ContextKind::automatic);
    const PlainPicture picture({204, 153, 230});
    const glm::vec3 bent = glm::normalize(glm::vec3(part(204), part(153), part(230)));
    const glm::vec3 to_light = glm::normalize(glm::vec3(0.5f, -0.2f, 0.8f));
    Scene scene = mapped_wall(with_normal_map(picture), to_light);
    CHECK(brightness(scene) == Approx(glm::dot(bent, to_light)).epsilon(1e-4));
    CHECK(brightness(scene, "-normal_maps") == Approx(to_light.z).epsilon(1e-4));

    // The texture runs to the left: so does the normal.
    for (glm::vec2& place : scene.texture_coordinates) {
        place.x = 1.0f - place.x;
    }
    const glm::vec3 mirrored = bent * glm::vec3(-1.0f, 1.0f, 1.0f);
    CHECK(brightness(scene) == Approx(glm::dot(mirrored, to_light)).epsilon(1e-4));

    // Turned by a quarter: u runs upwards and v to the left.
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        scene.texture_coordinates[i] = {scene.corners[i].y, -scene.corners[i].x};
    }
    const glm::vec3 turned(-bent.y, bent.x, bent.z);
    CHECK(brightness(scene) == Approx(glm::dot(turned, to_light)).epsilon(1e-4));

    // From behind, the normal is turned over as a whole.
    scene = mapped_wall(with_normal_map(picture), -to_light);
    scene.camera.eye.z = -4.0f;
    CHECK(brightness(scene) == Approx(glm::dot(bent, to_light)).epsilon(1e-4));
}

TEST_CASE("a map without a direction and a texture without an area bend nothing",
          "[09][normal_maps]") {
    const auto context = make_context(ContextKind::automatic);
    const glm::vec3 to_light = glm::normalize(glm::vec3(0.3f, 0.4f, 0.8f));
    const PlainPicture tilted({204, 153, 230});
    Scene scene = mapped_wall(with_normal_map(tilted), to_light);
    scene.texture_coordinates.assign(scene.corners.size(), glm::vec2(0.25f));
    CHECK(brightness(scene) == Approx(to_light.z).epsilon(1e-5));
    // Light that the bent normal faces and the wall does not stays behind it.
    scene = mapped_wall(with_normal_map(tilted), glm::normalize(glm::vec3(1.0f, 0.0f, -0.1f)));
    CHECK(brightness(scene) == 0.0f);
}

TEST_CASE("normal maps and emissive pictures run only where a material calls for them",
          "[09][normal_maps][emissive_maps][plan]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene plain = mapped_wall(white(), glm::vec3(0.0f, 0.0f, 1.0f));
    const EffectPicture picture = effect_picture(plain, 9);
    for (const PlannedPass& pass : picture.plan.passes) {
        CHECK(pass.name != "bend_normals");
        CHECK(pass.name != "add_glow");
        CHECK((!pass.parts.contains("normal") ||
               pass.parts.at("normal") == "normal/interpolated.glsl"));
    }
    CHECK(count_different(picture.image, effect_picture(plain, 9, "+emissive_maps").image) == 0);
    CHECK(count_different(picture.image, effect_picture(plain, 9, "+normal_maps").image) == 0);
    const PlainPicture tilted({204, 153, 230});
    Scene scene = mapped_wall(with_normal_map(tilted), glm::vec3(0.0f, 0.0f, 1.0f));
    CHECK_THAT(explain(make_plan(scene, 1.0, "", {})),
               contains_text("normal_maps:    material white, 2 triangles"));
    scene.lights.clear();
    CHECK(!has(make_plan(scene, 1.0, "", {}), Effect::normal_maps)); // nothing shows them
}

TEST_CASE("a surface glows by its picture and lights nothing else", "[09][emissive_maps]") {
    const auto context = make_context(ContextKind::automatic);
    const PlainPicture picture({255, 188, 0});
    Material glowing = white();
    glowing.emissive_map = picture.path();
    glowing.emissive_factor = {2.0f, 0.5f, 1.0f};
    Scene scene = mapped_wall(glowing, glm::vec3(0.0f, 0.0f, 1.0f));
    scene.lights.clear();
    const EffectPicture glow = effect_picture(scene, 3);
    CHECK(has(glow.plan, Effect::emissive_maps));
    CHECK(glow.tally.shadow == 0);
    for (const glm::vec3& pixel : glow.image.pixels) {
        CHECK(pixel.x == Approx(2.0f).epsilon(1e-5));
        CHECK(pixel.y == Approx(0.5f * decode_srgb(188)).epsilon(1e-5));
        CHECK(pixel.z == 0.0f);
    }
    for (const glm::vec3& pixel : effect_picture(scene, 3, "-emissive_maps").image.pixels) {
        CHECK(pixel == glm::vec3(0.0f));
    }
    // Light from elsewhere is added.
    scene.lights = {{{0.0f, 0.0f, 1e6f}, glm::vec3(1.0f)}};
    CHECK(effect_picture(scene, 1).image.at(0, 0).x == Approx(3.0f).epsilon(1e-5));
}

TEST_CASE("a map that cannot be read is named and bends and lights nothing",
          "[09][normal_maps][emissive_maps]") {
    const auto context = make_context(ContextKind::automatic);
    Material material = white();
    material.normal_map = "gone.png";
    material.emissive_map = "gone.png";
    const Scene scene = mapped_wall(material, glm::vec3(0.0f, 0.0f, 1.0f));
    const Plan plan = make_plan(scene, 1.0, "", {});
    const EffectBuffers buffers = upload_effects(scene, plan);
    REQUIRE(buffers.messages.size() == 2);
    CHECK_THAT(buffers.messages[0], contains_text("Material white: its normal map is left out. "));
    CHECK_THAT(buffers.messages[1], contains_text("its emissive picture is left out. gone.png"));
    CHECK(brightness(scene) == Approx(1.0f).epsilon(1e-5));
}
