#include "scene/samples/sample_scenes.h"

#include "basics/box.h"
#include "catch.h"
#include "scene/load_scene.h"
#include "scene_tests.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <filesystem>

using namespace raysteps;

namespace {

struct KnownSample {
    const char* name;
    int triangles;
    int open_edges; // of floors and the like; everything else is closed
};

// Small, so that all tests together take seconds.
const std::vector<KnownSample> known_samples = {
    {"mirrors", 2 * 12 * 8 + 20 * (36 + 16 + 9 + 1) + 5 * 12, 2 * (12 + 8)},
    {"cornell_box", 32, 4 + 4 + 2 * 4}, // the front of the room; the lamp; the blocks' bottoms
    {"sphereflake:0", 1280 + 2, 4},
    {"sphereflake:2", 1280 + 9 * 320 + 81 * 80 + 2, 4},
    {"tetrahedron:0", 4, 0},
    {"tetrahedron:5", 4096, 0},
    {"mount:0", 2 + 4 * 1280, 4},
    {"mount:5", 2 * 1024 + 4 * 1280, 4 * 32},
    {"compact:1", 20, 0},
    {"compact:21", 8820, 0},
    {"knot:1", 1024, 0},
    {"knot:3", 9216, 0},
    {"soup:1:0", 1, 3},
    {"soup:1000:5", 1000, 3000},
    {"stadium:2", 2152 + 4096, 52 + 2 * 10 + 2}, // the upper rim; the pitch
    {"needles:1:0", 1, 3},
    {"needles:1000:5", 1000, 3000},
};

} // namespace

TEST_CASE("each sample scene has the number of triangles that its formula says", "[scene]") {
    for (const KnownSample& known : known_samples) {
        CAPTURE(known.name);
        REQUIRE(triangle_count(make_sample_scene(known.name, 1.0f)) == known.triangles);
    }
}

TEST_CASE("only floors and the like of a sample scene have open edges", "[scene]") {
    for (const KnownSample& known : known_samples) {
        CAPTURE(known.name);
        REQUIRE(count_open_edges(make_sample_scene(known.name, 1.0f).corners) == known.open_edges);
    }
}

TEST_CASE("the arrays of a sample scene belong together", "[scene]") {
    for (const KnownSample& known : known_samples) {
        CAPTURE(known.name);
        const Scene scene = make_sample_scene(known.name, 1.0f);
        REQUIRE(scene.corners.size() % 3 == 0);
        REQUIRE(scene.normals.size() == scene.corners.size());
        REQUIRE(scene.texture_coordinates.size() == scene.corners.size());
        REQUIRE(scene.triangle_materials.size() == scene.corners.size() / 3);
        REQUIRE_FALSE(scene.lights.empty());
        REQUIRE_FALSE(scene.materials.empty());
        for (const int material : scene.triangle_materials) {
            REQUIRE(material >= 0);
            REQUIRE(material < static_cast<int>(scene.materials.size()));
        }
    }
}

TEST_CASE("the triangles of a sample scene have an area and normals on their front", "[scene]") {
    for (const KnownSample& known : known_samples) {
        CAPTURE(known.name);
        const Scene scene = make_sample_scene(known.name, 1.0f);
        bool is_sound = true;
        for (std::size_t i = 0; i < scene.corners.size(); i += 3) {
            const glm::dvec3 a(scene.corners[i]);
            const glm::dvec3 front = glm::cross(glm::dvec3(scene.corners[i + 1]) - a,
                                                glm::dvec3(scene.corners[i + 2]) - a);
            for (std::size_t j = i; j < i + 3; ++j) {
                const glm::dvec3 normal(scene.normals[j]);
                // Four roundings of 2^-24 relative to a component, and one of the square root.
                const bool is_unit = std::abs(glm::length(normal) - 1.0) < 5.0 * 0x1p-24;
                is_sound = is_sound && is_finite(scene.corners[j]) && is_unit &&
                           glm::dot(normal, front) > 0.0;
            }
        }
        REQUIRE(is_sound);
    }
}

TEST_CASE("a sample scene is named with all its parameters", "[scene]") {
    REQUIRE(make_sample_scene("soup:100", 1.0f).name == "soup:100:1");
    REQUIRE(make_sample_scene("knot", 1.0f).name == "knot:8");
    REQUIRE(make_sample_scene("mirrors", 1.0f).name == "mirrors");
}

TEST_CASE("the sample scene for a loop over every triangle is small", "[scene]") {
    REQUIRE(triangle_count(make_sample_scene("mirrors", 1.0f)) <= 1500);
}

TEST_CASE("the bunny is framed like its file", "[scene]") {
    const std::string path = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(path)) {
        REQUIRE_THROWS_WITH(load_scene("bunny", 1.5f),
                            "bunny: " + path + " is not there. Install the package glmark2-data.");
        return;
    }
    const Scene bunny = load_scene("bunny", 1.5f);
    const Scene file = load_scene(path, 1.5f);
    REQUIRE(triangle_count(bunny) == 69666);
    REQUIRE(bunny.name == "bunny");
    REQUIRE(bunny.models.empty());
    REQUIRE(bunny.corners == file.corners);
    REQUIRE(bunny.camera.eye == file.camera.eye);
    REQUIRE(bunny.camera.target == file.camera.target);
    REQUIRE(bunny.lights.size() == file.lights.size());
    REQUIRE(bunny.background == file.background);
}

TEST_CASE("every name that is listed can be loaded", "[scene]") {
    const std::string list = list_scenes();
    for (const SampleScene& sample : sample_scenes()) {
        CAPTURE(sample.name);
        REQUIRE(("\n" + list).find("\n" + std::string(sample.name)) != std::string::npos);
        if (sample.name != "bunny") {
            REQUIRE(triangle_count(load_scene(std::string(sample.name), 1.0f)) > 0);
        }
    }
}
