#include "scene/frame_scene.h"

#include "basics/error.h"
#include "catch.h"
#include "scene/shapes.h"
#include "scene/view.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace raysteps;

namespace {

// Where the camera shows a point: -1 and 1 are the picture's edges. Depth is along the line of
// sight.
struct PicturePoint {
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
};

PicturePoint project(const glm::vec3& point, const Camera& camera, float aspect_ratio) {
    const glm::dvec3 eye(camera.eye);
    const ViewFrame frame = view_frame(glm::dvec3(camera.target) - eye, camera.up);
    const glm::dvec3 offset = glm::dvec3(point) - eye;
    const double depth = glm::dot(offset, frame.forward);
    const double half_angle =
        glm::radians(static_cast<double>(camera.vertical_field_of_view)) / 2.0;
    const double half_height = depth * std::tan(half_angle);
    return {glm::dot(offset, frame.right) / (half_height * static_cast<double>(aspect_ratio)),
            glm::dot(offset, frame.up) / half_height, depth};
}

// How far out the corner is that is farthest from the picture's middle; up to 1 it is in the
// picture.
double farthest_out(const Box& box, const Camera& camera, float aspect_ratio) {
    double farthest = 0.0;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner{(i & 1) == 0 ? box.lower.x : box.upper.x,
                               (i & 2) == 0 ? box.lower.y : box.upper.y,
                               (i & 4) == 0 ? box.lower.z : box.upper.z};
        const PicturePoint point = project(corner, camera, aspect_ratio);
        if (point.depth <= 0.0) {
            return std::numeric_limits<double>::infinity(); // behind the camera
        }
        farthest = std::max({farthest, std::abs(point.x), std::abs(point.y)});
    }
    return farthest;
}

float number_between(int lowest, int highest) {
    return static_cast<float>(*rc::gen::inRange(lowest, highest + 1));
}

// Of any shape, flat ones and points included; somewhere up to a million of its sizes away.
Box random_box() {
    const glm::vec3 center{number_between(-1000, 1000), number_between(-1000, 1000),
                           number_between(-1000, 1000)};
    const glm::vec3 half_size{number_between(0, 1000), number_between(0, 1000),
                              number_between(0, 1000)};
    const float scale = std::ldexp(1.0f, *rc::gen::inRange(-10, 11));
    return {center - scale * half_size, center + scale * half_size};
}

} // namespace

TEST_CASE("the bounds of a scene are those of its corners", "[scene]") {
    const Scene scene = add_mesh({}, box({-1.0f, -2.0f, -3.0f}, {4.0f, 5.0f, 6.0f}), {});
    REQUIRE(bounds_of(scene.corners).lower == glm::vec3(-1.0f, -2.0f, -3.0f));
    REQUIRE(bounds_of(scene.corners).upper == glm::vec3(4.0f, 5.0f, 6.0f));
    REQUIRE(is_empty(bounds_of({})));
}

TEST_CASE("a framed box is seen from above right in front", "[scene]") {
    const Camera camera = frame_box({glm::vec3(-1.0f), glm::vec3(1.0f)}, 1.0f);
    REQUIRE(camera.target == glm::vec3(0.0f));
    REQUIRE(camera.eye.x > 0.0f);
    REQUIRE(camera.eye.y > 0.0f);
    REQUIRE(camera.eye.z > 0.0f);
    REQUIRE(camera.up == glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST_CASE("every corner of a framed box is in the picture", "[scene]") {
    REQUIRE(rc::check([] {
        const Box box = random_box();
        const float aspect_ratio = number_between(1, 400) / 100.0f;
        const Camera camera = frame_box(box, aspect_ratio);
        RC_ASSERT(camera.eye != camera.target);
        RC_ASSERT(farthest_out(box, camera, aspect_ratio) <= 1.0);
    }));
}

TEST_CASE("a framed box is cut off where the camera goes nearer", "[scene]") {
    REQUIRE(rc::check([] {
        Box box = random_box();
        box.upper = glm::max(box.upper, box.lower + 1.0f);
        const float aspect_ratio = number_between(25, 400) / 100.0f;
        Camera camera = frame_box(box, aspect_ratio);
        // The eye is 1.02 times as far away as it has to be: 0.95 * 1.02 < 1.
        camera.eye = camera.target + 0.95f * (camera.eye - camera.target);
        RC_ASSERT(farthest_out(box, camera, aspect_ratio) > 1.0);
    }));
}

TEST_CASE("an empty box and a point have a camera that looks somewhere", "[scene]") {
    for (const Box& box :
         {Box{}, Box{glm::vec3(0.0f), glm::vec3(0.0f)}, Box{glm::vec3(1e6f), glm::vec3(1e6f)}}) {
        const Camera camera = frame_box(box, 1.0f);
        REQUIRE(camera.eye != camera.target);
        REQUIRE(std::isfinite(glm::length(camera.eye)));
    }
}

TEST_CASE("a scene that is too large for a camera is refused", "[scene]") {
    Scene scene = add_mesh({}, box(glm::vec3(-1.8e18f), glm::vec3(1.8e18f)), {});
    scene.name = "universe";
    REQUIRE_THROWS_WITH(frame_camera(scene, 1.0f), starts_with_text("universe: this is too large"));
    // The eye would be at some 1.1e19: an eighth of that is near enough.
    REQUIRE_THROWS_WITH(frame_camera(scene, 1.0f), contains_text("scale = 0.125, which"));
    REQUIRE_NOTHROW(frame_camera(add_mesh({}, box(glm::vec3(-1e17f), glm::vec3(1e17f)), {}), 1.0f));
    Camera own;
    own.eye = {1.0f, 2.0f, 1.7e18f};
    REQUIRE(frame_scene(scene, 1.0f, own).camera.eye == own.eye);
    own.eye.z = 1.9e18f;
    REQUIRE_THROWS_WITH(frame_camera(scene, 1.0f, own), contains_text("too large"));
    // Where a camera can be placed, it is.
    REQUIRE(frame_camera(add_mesh({}, box({-1, -1, -1}, {1, 1, 1}), {}), 1.0f, own).eye.z < 10.0f);
}

TEST_CASE("the bright light is above left of the camera and the dim one on its right", "[scene]") {
    Camera camera;
    camera.eye = {10.0f, 0.0f, 0.0f};
    camera.target = {0.0f, 0.0f, 0.0f};
    const std::vector<Light> lights = place_lights(camera); // right is -z here
    REQUIRE(lights.size() == 2);
    REQUIRE(lights[0].position.y > 0.0f);
    REQUIRE(lights[0].position.z > 0.0f);
    REQUIRE(lights[1].position.y > 0.0f);
    REQUIRE(lights[1].position.z < 0.0f);
    REQUIRE(glm::length(lights[0].color) > 2.0f * glm::length(lights[1].color));
}

TEST_CASE("a narrow picture still shows what a square one shows", "[scene]") {
    const Camera camera;
    REQUIRE(keep_square_in_view(camera, 1.0f).vertical_field_of_view == 40.0f);
    REQUIRE(keep_square_in_view(camera, 2.0f).vertical_field_of_view == 40.0f);
    // tan(20 degrees) / 0.5 = tan(36.0523 degrees)
    REQUIRE(keep_square_in_view(camera, 0.5f).vertical_field_of_view ==
            Approx(72.1047).epsilon(1e-5));
}

TEST_CASE("a framed scene is the same every time", "[scene]") {
    const Scene scene = add_mesh({}, box(glm::vec3(0.1f), glm::vec3(0.7f)), {});
    const Scene first = frame_scene(scene, 1.6f);
    const Scene second = frame_scene(scene, 1.6f);
    REQUIRE(first.camera.eye == second.camera.eye);
    REQUIRE(first.lights[1].position == second.lights[1].position);
    REQUIRE(first.background == calm_background);
}
