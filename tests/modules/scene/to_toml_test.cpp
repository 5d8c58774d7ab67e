#include "catch.h"
#include "scene/load_scene.h"
#include "scene/toml/toml_values.h"
#include "scene_tests.h"

#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdint>

using namespace raysteps;

namespace {

Scene read_back(const Scene& scene) {
    // Another place than where the models are: their paths are absolute.
    return read_toml_scene(to_toml(scene), "elsewhere/scene.toml", 1.0f);
}

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool same_bits(const glm::vec3& a, const glm::vec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

bool same_bits(const Light& a, const Light& b) {
    return same_bits(a.position, b.position) && same_bits(a.color, b.color);
}

bool same_bits(const Camera& a, const Camera& b) {
    return same_bits(a.eye, b.eye) && same_bits(a.target, b.target) && same_bits(a.up, b.up) &&
           same_bits(a.vertical_field_of_view, b.vertical_field_of_view);
}

bool same_bits(const Model& a, const Model& b) {
    return a.path == b.path && a.transform == b.transform;
}

template <class Vector>
bool same_bits(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    if (a.size() != b.size()) {
        return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!same_bits(a[i], b[i])) {
            return false;
        }
    }
    return true;
}

bool same_bits(const Scene& a, const Scene& b) {
    return a.name == b.name && same_bits(a.corners, b.corners) && same_bits(a.normals, b.normals) &&
           a.triangle_materials == b.triangle_materials &&
           a.materials.size() == b.materials.size() && same_bits(a.lights, b.lights) &&
           same_bits(a.camera, b.camera) && same_bits(a.background, b.background) &&
           same_bits(a.models, b.models);
}

// Any bits that are a finite float within the limit.
float any_float(float limit) {
    return *rc::gen::suchThat(
        rc::gen::map(rc::gen::arbitrary<std::uint32_t>(),
                     [](std::uint32_t bits) { return std::bit_cast<float>(bits); }),
        [limit](float number) { return std::abs(number) <= limit; });
}

glm::vec3 any_vec3(float limit) {
    const float x = any_float(limit);
    const float y = any_float(limit);
    return {x, y, any_float(limit)};
}

glm::vec3 any_color() {
    return glm::abs(any_vec3(1e6f));
}

Camera any_camera() {
    Camera camera;
    camera.eye = any_vec3(1.8e18f);
    camera.target = camera.eye;
    camera.target.z = *rc::gen::element(-1.7e18f, 0.0f, 1.7e18f);
    RC_PRE(camera.target != camera.eye);
    camera.up = {any_float(1.0f), *rc::gen::element(-1.0f, 1.0f), 0.0f};
    camera.vertical_field_of_view = std::abs(any_float(179.99f));
    RC_PRE(camera.vertical_field_of_view > 0.0f);
    return camera;
}

std::vector<Light> any_lights() {
    std::vector<Light> lights(*rc::gen::inRange<std::size_t>(0, 4));
    for (Light& light : lights) {
        light = {any_vec3(8.4e18f), any_color()};
    }
    return lights;
}

// Rounded sixteenths, so that corners stay in range and columns are clearly independent.
glm::mat4 any_transform() {
    glm::mat4 transform{1.0f};
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            const int diagonal = column == row ? 100 : 0;
            transform[column][row] =
                static_cast<float>(diagonal + *rc::gen::inRange(-30, 31)) / 7.0f;
        }
    }
    return transform;
}

} // namespace

TEST_CASE("a number is written with the digits that bring it back", "[scene][toml]") {
    REQUIRE(toml_number_text(0.1f) == "0.1");
    REQUIRE(toml_number_text(-0.0f) == "-0.0");
    REQUIRE(toml_number_text(3.0f) == "3.0");
    REQUIRE(toml_number_text(16777216.0f) == "16777216.0");
    REQUIRE(toml_number_text(1e30f) == "1e+30");
    // The one float whose shortest digits mean another one once they were a double.
    REQUIRE(toml_number_text(std::bit_cast<float>(0x15ae43fdu)) == "7.03853069e-26");
}

TEST_CASE("a text is written so that TOML reads the same", "[scene][toml]") {
    REQUIRE(toml_string_text("plain") == "\"plain\"");
    REQUIRE(toml_string_text("a\"b\\c\nd\x7f") == "\"a\\\"b\\\\c\\u000Ad\\u007F\"");
}

TEST_CASE("the text of every sample scene reads back to the same scene", "[scene][toml]") {
    for (const char* name : {"mirrors", "cornell_box", "sphereflake:1", "tetrahedron:2", "mount:2",
                             "compact:3", "knot:1", "soup:50:9", "stadium:1", "needles:50:9"}) {
        CAPTURE(name);
        const Scene scene = load_scene(name, 0.7f);
        REQUIRE(same_bits(read_back(scene), scene));
    }
}

TEST_CASE("the text of a bare model reads back to the same scene", "[scene][toml]") {
    const Scene scene = load_scene((scene_files / "pyramid.obj").string(), 1.5f);
    REQUIRE(scene.name == "pyramid");
    REQUIRE(same_bits(read_back(scene), scene));
}

TEST_CASE("the path of a model is absolute so that the text may be saved anywhere",
          "[scene][toml]") {
    const std::filesystem::path relative = std::filesystem::relative(scene_files / "pyramid.obj");
    const Scene scene = load_scene(relative.string(), 1.5f);
    REQUIRE(std::filesystem::path(scene.models[0].path).is_absolute());
    REQUIRE(same_bits(read_back(scene), scene));
}

TEST_CASE("the text of a scene file's scene reads back to the same scene", "[scene][toml]") {
    const Scene scene = load_scene((scene_files / "two_pyramids.toml").string(), 1.5f);
    REQUIRE(same_bits(read_back(scene), scene));
}

TEST_CASE("every camera and light and color comes back bit for bit", "[scene][toml]") {
    REQUIRE(rc::check([] {
        Scene scene = load_scene("compact:1", 1.0f);
        scene.camera = any_camera();
        scene.lights = any_lights();
        scene.background = any_color();
        RC_ASSERT(same_bits(read_back(scene), scene));
    }));
}

TEST_CASE("every transform and name of a model comes back bit for bit", "[scene][toml]") {
    REQUIRE(rc::check([] {
        Scene scene = load_scene((scene_files / "pyramid.obj").string(), 1.0f);
        scene.name = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
        scene.models = {{scene.models[0].path, any_transform()},
                        {scene.models[0].path, any_transform()}};
        const Scene first = read_back(scene);
        RC_ASSERT(first.name == scene.name);
        RC_ASSERT(same_bits(first.models, scene.models));
        RC_ASSERT(same_bits(read_back(first), first));
    }));
}
