#include "scene/camera_text.h"

#include "cameras.h"
#include "catch.h"
#include "program/window/trackball.h"

#include <algorithm>

using namespace raysteps;

namespace {

const std::string option = "--camera ";

std::string numbers_of(const std::string& text) {
    return text.substr(option.size());
}

} // namespace

TEST_CASE("a camera is printed as the option takes it", "[window]") {
    const Camera camera{{3.0f, 2.5f, -8.0f}, {1.0f, 0.1f, 0.0f}, {0.0f, 1.0f, 0.0f}, 35.0f};
    CHECK(camera_text(camera, {0.0f, 1.0f, 0.0f}) == "--camera 3,2.5,-8,1,0.1,0,35");
}

TEST_CASE("a tilted camera is printed with its up", "[window]") {
    CHECK(camera_text(roll(Camera{}, 0.5), {0.0f, 1.0f, 0.0f}) ==
          "--camera 0,0,5,0,0,0,40,0.47942555,0.87758255,0");
}

TEST_CASE("an orbit to the side alone is no tilt", "[window]") {
    const std::string text = camera_text(orbit(Camera{}, {0.3, 0.0}), {0.0f, 1.0f, 0.0f});
    CHECK(std::count(text.begin(), text.end(), ',') == 6);
}

TEST_CASE("the option that is printed gives the same tilted camera again", "[window]") {
    const Camera camera = roll(orbit(Camera{}, {0.3, 0.2}), 0.7);
    const Camera start{};
    const Camera read = parse_camera(numbers_of(camera_text(camera, start.up)), start);
    CHECK(read.eye == camera.eye);
    CHECK(read.up == camera.up);
}

TEST_CASE("the option that is printed gives the same camera again", "[window]") {
    REQUIRE(rc::check("round trip", [] {
        const Camera camera = random_camera();
        const Camera read = parse_camera(numbers_of(camera_text(camera, camera.up)), camera);
        RC_ASSERT(read.eye == camera.eye);
        RC_ASSERT(read.target == camera.target);
        RC_ASSERT(read.vertical_field_of_view == camera.vertical_field_of_view);
    }));
}
