#include "basics/error.h"
#include "catch.h"
#include "scene/load_scene.h"
#include "scene/scaling.h"
#include "scene_tests.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace raysteps;

namespace {

// A file of one triangle of that size, that is gone when the test ends.
class TriangleFile {
public:
    explicit TriangleFile(double size) {
        std::ofstream file(path_);
        file << "v 0 0 0\nv " << size << " 0 0\nv 0 " << size << " 0\nf 1 2 3\n";
    }
    ~TriangleFile() { std::filesystem::remove(path_); }
    TriangleFile(const TriangleFile&) = delete;
    TriangleFile& operator=(const TriangleFile&) = delete;

    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_ = std::filesystem::temp_directory_path() / "small_triangle.obj";
};

std::string messages_of(const Scene& scene) {
    std::string all;
    for (const std::string& message : scene.messages) {
        all += message + "\n";
    }
    return all;
}

} // namespace

TEST_CASE("a model that is too small for floats is said when it is loaded", "[scene][scale]") {
    CHECK_THAT(messages_of(load_scene(TriangleFile(1e-14).path(), 1.0f)),
               contains_text("its largest side is 1e-14") &&
                   contains_text("Add --scale-exponent 47"));
    // 2^-38 is 3.638e-12.
    CHECK_THAT(messages_of(load_scene(TriangleFile(3.63e-12).path(), 1.0f)),
               contains_text("--scale-exponent"));
    CHECK_THAT(messages_of(load_scene(TriangleFile(3.64e-12).path(), 1.0f)),
               !contains_text("--scale-exponent"));
}

TEST_CASE("a scaled model has its lengths times a power of two, and its camera sees the same",
          "[scene][scale]") {
    const std::string file = (scene_files / "two_pyramids.toml").string();
    const Scene scene = load_scene(file, 1.0f);
    const Scene large = load_scene(file, 1.0f, {.scale_exponent = 12});
    REQUIRE(large.corners.size() == scene.corners.size());
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        REQUIRE(large.corners[i] == 4096.0f * scene.corners[i]);
    }
    CHECK(large.normals == scene.normals);
    CHECK(large.camera.eye == 4096.0f * scene.camera.eye);
    CHECK(large.camera.target == 4096.0f * scene.camera.target);
    CHECK(large.camera.up == scene.camera.up);
    REQUIRE(large.lights.size() == scene.lights.size());
    CHECK(large.lights[0].position == 4096.0f * scene.lights[0].position);
    CHECK(large.lights[0].color == scene.lights[0].color);
}

TEST_CASE("glass that is scaled keeps the same light on a scaled way", "[scene][scale]") {
    Material glass;
    glass.transmission = {0.25f, 1.0f, 0.0f};
    const Material larger = scaled(glass, 1); // a way of 1 is one of 2 now: 0.5 * 0.5 = 0.25
    CHECK(larger.transmission == glm::vec3(0.5f, 1.0f, 0.0f));
}

TEST_CASE("a sample scene has no scale, and a scale has its range", "[scene][scale]") {
    CHECK_THROWS_WITH(load_scene("cornell_box", 1.0f, {.scale_exponent = 3}),
                      contains_text("made by code"));
    CHECK_THROWS_WITH(load_scene(TriangleFile(1.0).path(), 1.0f, {.scale_exponent = 61}),
                      contains_text("-60 to 60"));
    const Ray long_ray{{0, 0, 0}, {1e30f, 0, 0}, 0.0f, 1.0f};
    CHECK_THROWS_AS(scaled(long_ray, 60), InputError);
}

TEST_CASE("a ray that is scaled there and back is the same", "[scene][scale]") {
    const Ray ray{{1e-20f, -3e-19f, 0.0f}, {5e-18f, 0.0f, -0.0f}, 0.5f, 7.0f};
    const Ray there = scaled(ray, 60);
    CHECK(there.t_min == ray.t_min);
    CHECK(there.t_max == ray.t_max);
    CHECK(scaled(there, -60).origin == ray.origin);
    CHECK(scaled(there, -60).direction == ray.direction);
}
