#include "scene/samples/samples.h"

#include "catch.h"
#include "scene/frame_scene.h"

#include <algorithm>

using namespace raysteps;

namespace {

bool has_corner(const Scene& scene, const glm::vec3& corner) {
    return std::find(scene.corners.begin(), scene.corners.end(), corner) != scene.corners.end();
}

} // namespace

TEST_CASE("the Cornell box has the measured size", "[scene]") {
    const Scene scene = sample_cornell_box();
    const Box box = bounds_of(scene.corners);
    REQUIRE(box.lower == glm::vec3(0.0f));
    REQUIRE(box.upper == glm::vec3(556.0f, 548.8f, 559.2f)); // the floor is 552.8 wide in front
    REQUIRE(has_corner(scene, {552.8f, 0.0f, 0.0f}));
    REQUIRE(has_corner(scene, {549.6f, 0.0f, 559.2f}));
    REQUIRE(has_corner(scene, {290.0f, 165.0f, 114.0f}));
    REQUIRE(has_corner(scene, {423.0f, 330.0f, 247.0f}));
}

TEST_CASE("the Cornell box is seen through a lens of 35 mm on a film of 25 mm", "[scene]") {
    const Camera camera = sample_cornell_box().camera;
    REQUIRE(camera.eye == glm::vec3(278.0f, 273.0f, -800.0f));
    REQUIRE(camera.target == glm::vec3(278.0f, 273.0f, 0.0f));
    // 2 atan(12.5 / 35), by hand: 39.30765 degrees, in digits of 1e-5
    REQUIRE(camera.vertical_field_of_view == Approx(39.30765).margin(1e-5));
}

TEST_CASE("the left wall of the Cornell box is red and the right one green", "[scene]") {
    const Scene scene = sample_cornell_box();
    for (std::size_t first = 0; first < scene.corners.size(); first += 3) {
        const Material& material =
            scene.materials[static_cast<std::size_t>(scene.triangle_materials[first / 3])];
        // Who looks along +z has -x on the right.
        if (scene.normals[first] == glm::vec3(1.0f, 0.0f, 0.0f)) {
            REQUIRE(material.name == "green");
        }
        if (material.name == "red") {
            REQUIRE(scene.normals[first].x < -0.99f);
        }
    }
}

TEST_CASE("the lamp of the Cornell box hangs under the ceiling and over the light", "[scene]") {
    const Scene scene = sample_cornell_box();
    int lamp_corners = 0;
    for (std::size_t i = 0; i < scene.corners.size(); ++i) {
        const auto index = static_cast<std::size_t>(scene.triangle_materials[i / 3]);
        if (scene.materials[index].emission != glm::vec3(0.0f)) {
            ++lamp_corners;
            REQUIRE(scene.corners[i].y < 548.8f);
            REQUIRE(scene.corners[i].y > scene.lights[0].position.y);
        }
    }
    REQUIRE(lamp_corners == 6);
    REQUIRE(scene.background == glm::vec3(0.0f));
}
