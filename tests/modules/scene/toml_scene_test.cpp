#include "scene/load_scene.h"

#include "catch.h"
#include "scene/frame_scene.h"
#include "scene_tests.h"

#include <glm/geometric.hpp>

#include <fstream>
#include <sstream>

using namespace raysteps;

namespace {

Scene read(const std::string& text) {
    return read_toml_scene(text, scene_files / "scene.toml", 1.0f);
}

// Of a pyramid over the square from -1 to 1, of height 1.5.
Box bounds_of_model(const std::string& keys) {
    return bounds_of(read("[[model]]\npath = 'pyramid.obj'\n" + keys).corners);
}

std::string text_of_file(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace

TEST_CASE("a scene file gives camera and lights and models", "[scene][toml]") {
    const Scene scene = load_scene((scene_files / "two_pyramids.toml").string(), 1.0f);
    REQUIRE(scene.name == "two_pyramids");
    REQUIRE(triangle_count(scene) == 12);
    REQUIRE(scene.background == glm::vec3(0.1f, 0.2f, 0.3f));
    REQUIRE(scene.camera.eye == glm::vec3(0.0f, 2.0f, 9.0f));
    REQUIRE(scene.camera.target == glm::vec3(0.0f, 1.0f, 0.0f));
    REQUIRE(scene.camera.up == glm::vec3(0.0f, 1.0f, 0.0f));
    REQUIRE(scene.camera.vertical_field_of_view == 30.0f);
    REQUIRE(scene.lights.size() == 1);
    REQUIRE(scene.lights[0].position == glm::vec3(5.0f, 6.0f, 7.0f));
    REQUIRE(scene.lights[0].color == glm::vec3(0.9f, 0.8f, 0.7f));
    REQUIRE(scene.models.size() == 2);
    REQUIRE(std::filesystem::path(scene.models[0].path).is_absolute());
    REQUIRE(count_open_edges(scene.corners) == 0);
    REQUIRE(bounds_of(scene.corners).upper.y == 3.0f);
}

TEST_CASE("a light is white where the file names no color", "[scene][toml]") {
    const Scene scene = read("sample = 'mirrors'\n[[light]]\nposition = [1, 2, 3]\n");
    REQUIRE(scene.lights.size() == 1);
    REQUIRE(scene.lights[0].color == glm::vec3(1.0f));
}

TEST_CASE("a file without camera and light gets them and says so", "[scene][toml]") {
    const Scene scene = read("[[model]]\npath = 'pyramid.obj'\n");
    const Scene bare = load_scene((scene_files / "pyramid.obj").string(), 1.0f);
    REQUIRE(scene.camera.eye == bare.camera.eye);
    REQUIRE(scene.lights.size() == 2);
    REQUIRE(scene.lights[0].position == bare.lights[0].position);
    REQUIRE(scene.background == bare.background);
    REQUIRE(scene.corners == bare.corners);
    const std::string path = (scene_files / "scene.toml").string();
    REQUIRE(scene.messages.size() >= 2);
    REQUIRE(scene.messages.back() == "No light in " + path + ": two were placed.");
}

TEST_CASE("an empty list of lights means darkness", "[scene][toml]") {
    REQUIRE(read("light = []\n[[model]]\npath = 'pyramid.obj'\n").lights.empty());
}

TEST_CASE("a sample in a file keeps what the file does not say", "[scene][toml]") {
    const Scene sample = load_scene("sphereflake:1", 1.0f);
    const Scene scene = read("sample = 'sphereflake:1'\nbackground = [1, 0, 0.5]\n");
    REQUIRE(scene.name == "sphereflake:1");
    REQUIRE(scene.corners == sample.corners);
    REQUIRE(scene.camera.eye == sample.camera.eye);
    REQUIRE(scene.lights.size() == sample.lights.size());
    REQUIRE(scene.background == glm::vec3(1.0f, 0.0f, 0.5f));
}

TEST_CASE("a model is scaled then rotated then translated", "[scene][toml]") {
    const Box moved = bounds_of_model("translate = [10, 20, 30]\n");
    REQUIRE(moved.lower == glm::vec3(9.0f, 20.0f, 29.0f));
    REQUIRE(moved.upper == glm::vec3(11.0f, 21.5f, 31.0f));
    const Box scaled = bounds_of_model("scale = [2, 3, 4]\n");
    REQUIRE(scaled.upper == glm::vec3(2.0f, 4.5f, 4.0f));
    REQUIRE(bounds_of_model("scale = 2\n").upper == glm::vec3(2.0f, 3.0f, 2.0f));
    // A quarter turn around z takes x to y and y to -x.
    const Box turned = bounds_of_model("scale = [2, 1, 1]\ntranslate = [0, 0, 5]\n"
                                       "rotate = { axis = [0, 0, 3], degrees = 90 }\n");
    // cos(pi / 2) in double is 6e-17, and all are rounded to floats of size 1 to 6: 2^-22.
    REQUIRE(turned.lower.x == Approx(-1.5f).margin(0x1p-22));
    REQUIRE(turned.upper.y == Approx(2.0f).margin(0x1p-22));
    REQUIRE(turned.upper.z == 6.0f);
}

TEST_CASE("a matrix is given row by row", "[scene][toml]") {
    const Box box = bounds_of_model("matrix = [0,0,1,5, 1,0,0,6, 0,2,0,7, 0,0,0,1]\n");
    // x' = z + 5, y' = x + 6, z' = 2 y + 7
    REQUIRE(box.lower == glm::vec3(4.0f, 5.0f, 7.0f));
    REQUIRE(box.upper == glm::vec3(6.0f, 7.0f, 10.0f));
}

TEST_CASE("a mirrored model in a file keeps its fronts outside", "[scene][toml]") {
    const Scene scene = read("[[model]]\npath = 'pyramid.obj'\nscale = [1, 1, -1]\n");
    REQUIRE(signed_volume(scene.corners) == 2.0); // 4 * 1.5 / 3
}

TEST_CASE("the ending of a file may be in capital letters", "[scene][toml]") {
    const std::filesystem::path path =
        std::filesystem::path(RAYSTEPS_BINARY_DIR) / "CAPITAL_LETTERS.TOML";
    std::ofstream(path) << "sample = 'compact:1'\n";
    REQUIRE(triangle_count(load_scene(path.string(), 1.0f)) == 20);
}

TEST_CASE("the examples in the documentation are scene files", "[scene][toml]") {
    const std::string page =
        text_of_file(std::filesystem::path(RAYSTEPS_SOURCE_DIR) / "docs" / "scene_files.md");
    const std::string fence = "```toml\n";
    int examples = 0;
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
        at += fence.size();
        const std::string example = page.substr(at, page.find("```", at) - at);
        CAPTURE(example);
        REQUIRE_NOTHROW(read(example));
        ++examples;
    }
    REQUIRE(examples >= 2);
}
