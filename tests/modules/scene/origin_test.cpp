#include "catch.h"
#include "scene/camera_text.h"
#include "scene/load_scene.h"
#include "scene/ray_file.h"
#include "scene/scaling.h"
#include "support/same_bits.h"
#include "support/scratch_folder.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <string>

using namespace raysteps;

namespace {

// A pyramid 20 wide in map coordinates, with digits that no float has beside them.
constexpr const char* pyramid_far_away = "v 448262.1250 5411932.7500 105.5\n"
                                         "v 448282.1250 5411932.7500 105.5\n"
                                         "v 448282.1250 5411952.8125 105.5\n"
                                         "v 448272.3125 5411942.0625 120.03125\n"
                                         "v 0 0 0\n" // which no face names
                                         "f 1 2 4\nf 2 3 4\nf 3 1 4\nf 3 2 1\n";

std::string all_messages(const Scene& scene) {
    std::string all;
    for (const std::string& message : scene.messages) {
        all += message + "\n";
    }
    return all;
}

bool same_scene(const Scene& a, const Scene& b) {
    bool same = a.corners == b.corners && a.lights.size() == b.lights.size() &&
                same_bits(a.camera.eye, b.camera.eye) &&
                same_bits(a.camera.target, b.camera.target) && a.origin == b.origin;
    for (std::size_t i = 0; same && i < a.lights.size(); ++i) {
        same = same_bits(a.lights[i].position, b.lights[i].position);
    }
    return same;
}

} // namespace

TEST_CASE("a model in map coordinates keeps its digits and says what was taken from them",
          "[scene][origin]") {
    const ScratchFolder folder("far_away");
    put_bytes(folder / "far.obj", pyramid_far_away);
    const Scene scene = load_scene((folder / "far.obj").string(), 1.0f);
    CHECK(scene.origin == glm::round(scene.origin)); // a whole number
    CHECK(glm::distance(scene.origin, glm::dvec3(448272, 5411942, 112)) < 20.0);
    REQUIRE(triangle_count(scene) == 4);
    // These digits are binary ones, so they are there to the last.
    CHECK(glm::dvec3(scene.corners[0]) + scene.origin == glm::dvec3(448262.125, 5411932.75, 105.5));
    CHECK(glm::dvec3(scene.corners[2]) + scene.origin ==
          glm::dvec3(448272.3125, 5411942.0625, 120.03125));
    CHECK_THAT(all_messages(scene), contains_text("floats would leave steps of 0.5") &&
                                        contains_text("was taken from all its coordinates"));
    // The camera is as near as to any model of that size.
    CHECK(glm::distance(scene.camera.eye, scene.camera.target) < 100.0f);
}

TEST_CASE("coordinates that floats hold well stay as they are", "[scene][origin]") {
    const auto offset = [](double from, double to) {
        return offset_of({glm::dvec3(from), glm::dvec3(to)});
    };
    CHECK(offset(-1.0, 1.0) == glm::dvec3(0.0));
    CHECK(offset(15.0, 16.0) == glm::dvec3(0.0));
    CHECK(offset(15.0, 15.9) != glm::dvec3(0.0)); // 15.9 > 16 * 0.9
    CHECK(offset(5.0, 5.0) == glm::dvec3(0.0));   // a point
    CHECK(offset_of({}) == glm::dvec3(0.0));
    // A model of 2^-10 near 1 needs parts of that size.
    CHECK(offset(1.0, 1.0 + 0x1p-10) == glm::dvec3(1.0 + 0x1p-11));
}

TEST_CASE("the text of a scene far away reads back to the same scene", "[scene][origin][toml]") {
    const ScratchFolder folder("far_text");
    put_bytes(folder / "far.obj", pyramid_far_away);
    const Scene scene = load_scene((folder / "far.obj").string(), 1.0f);
    const std::string text = to_toml(scene);
    CHECK_THAT(text, contains_text("origin = [448") && contains_text("eye = [448"));
    CHECK(same_scene(read_toml_scene(text, folder / "far.toml", 1.0f), scene));
}

TEST_CASE("models of a scene file share an origin and stand as they stood", "[scene][origin]") {
    const ScratchFolder folder("far_pair");
    put_bytes(folder / "far.obj", pyramid_far_away);
    const std::string text = "[[model]]\npath = \"far.obj\"\n\n[[model]]\npath = \"far.obj\"\n"
                             "translate = [100, 0, 0]\n\n[camera]\n"
                             "eye = [448272.0, 5411900.0, 130.0]\n"
                             "target = [448272.0, 5411942.0, 110.0]\nup = [0, 0, 1]\n";
    const Scene scene = read_toml_scene(text, folder / "pair.toml", 1.0f);
    REQUIRE(triangle_count(scene) == 8);
    for (std::size_t i = 0; i < 12; ++i) {
        CHECK(scene.corners[i + 12] - scene.corners[i] == glm::vec3(100, 0, 0));
    }
    CHECK(glm::dvec3(scene.camera.eye) + scene.origin == glm::dvec3(448272.0, 5411900.0, 130.0));
}

TEST_CASE("cameras and rays are given in the coordinates of the file", "[scene][origin]") {
    const glm::dvec3 origin(448256, 5411936, 112);
    const Camera camera =
        parse_camera("448262.25,5411932.5,105.125,448272,5411942,110,35", {}, origin);
    CHECK(camera.eye == glm::vec3(6.25f, -3.5f, -6.875f));
    CHECK(camera.target == glm::vec3(16.0f, 6.0f, -2.0f));
    CHECK(camera_text(camera, {0.0f, 1.0f, 0.0f}, origin) ==
          "--camera 448262.25,5411932.5,105.125,448272,5411942,110,35");
    const std::vector<Ray> rays =
        parse_ray_csv("origin_x,origin_y,origin_z,direction_x,direction_y,direction_z,t_min,t_max\n"
                      "448262.25,5411932.5,105.125,0,0,1,0,10\n",
                      "rays.csv", origin);
    REQUIRE(rays.size() == 1);
    CHECK(rays[0].origin == glm::vec3(6.25f, -3.5f, -6.875f));
    CHECK(rays[0].direction == glm::vec3(0, 0, 1));
}

TEST_CASE("edges that floats hardly tell apart are said", "[scene][origin]") {
    const ScratchFolder folder("small_edge");
    put_bytes(folder / "edge.obj", "v 0 0 0\nv 100 0 0\nv 100 0.0001 0\nf 1 2 3\n");
    // 24 + log2(1e-4 / 100) = 4.07
    CHECK_THAT(all_messages(load_scene((folder / "edge.obj").string(), 1.0f)),
               contains_text("a float has 4.1 bits left for the smallest edge, 0.0001"));
    put_bytes(folder / "edge.obj", "v 0 0 0\nv 100 0 0\nv 100 1 0\nf 1 2 3\n");
    CHECK_THAT(all_messages(load_scene((folder / "edge.obj").string(), 1.0f)),
               !contains_text("bits left"));
}
