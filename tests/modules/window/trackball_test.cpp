#include "program/window/trackball.h"

#include "cameras.h"
#include "catch.h"

#include <glm/trigonometric.hpp>

#include <algorithm>

using namespace raysteps;

namespace {

// For known answers of size 5: the rounding of a float is 2^-24 of that.
constexpr float exact = 1e-6f;

void check_near(const glm::vec3& found, const glm::vec3& expected) {
    CAPTURE(found.x, found.y, found.z);
    CHECK(glm::distance(found, expected) <= exact);
}

const Camera from_front{{0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 90.0f};

constexpr double quarter = 90.0 / 200.0; // of a turn, in windows

} // namespace

TEST_CASE("a drag to the right moves the eye round to the left", "[window]") {
    const Camera camera = orbit(from_front, {quarter, 0.0});
    check_near(camera.eye, {-5.0f, 0.0f, 0.0f});
    check_near(camera.up, {0.0f, 1.0f, 0.0f});
    check_near(camera.target, from_front.target);
}

TEST_CASE("a drag upward moves the eye down and turns up with it", "[window]") {
    const Camera camera = orbit(from_front, {0.0, quarter});
    check_near(camera.eye, {0.0f, -5.0f, 0.0f});
    check_near(camera.up, {0.0f, 0.0f, 1.0f});
}

TEST_CASE("an orbit passes over the poles and comes round to where it began", "[window]") {
    Camera camera = from_front;
    const int steps = 360;
    for (int step = 0; step < steps; ++step) {
        camera = orbit(camera, {0.0, 1.0 / 200.0});
        REQUIRE(is_sound(camera));
    }
    // Each step rounds eye and up, by 5 * sqrt(3) * 2^-24 = 5e-7 at most.
    CHECK(glm::distance(camera.eye, from_front.eye) <= 2.0f * steps * 5e-7f);
    CHECK(glm::distance(camera.up, from_front.up) <= 2.0f * steps * 5e-7f);
}

TEST_CASE("a pan moves eye and target against the mouse", "[window]") {
    // The window is 10 high and 20 wide at the target.
    const Camera camera = pan(from_front, {0.1, 0.2}, 2.0);
    check_near(camera.eye, {-2.0f, -2.0f, 5.0f});
    check_near(camera.target, {-2.0f, -2.0f, 0.0f});
}

TEST_CASE("a dolly by two halves the distance", "[window]") {
    const Camera camera = dolly(from_front, 2.0);
    check_near(camera.eye, {0.0f, 0.0f, 2.5f});
    check_near(camera.target, from_front.target);
}

TEST_CASE("a roll by a quarter puts up to the right so that the picture turns left", "[window]") {
    const Camera camera = roll(from_front, glm::radians(90.0));
    check_near(camera.up, {1.0f, 0.0f, 0.0f});
    check_near(camera.eye, from_front.eye);
}

TEST_CASE("no zoom makes the eye meet the target or leave the numbers", "[window]") {
    const glm::vec3 shift = GENERATE(glm::vec3(0.0f), glm::vec3(1000.0f, -3.0f, 7.0f));
    for (const double factor : {1.21, 1.0 / 1.21, 1e300, 1e-300}) {
        Camera camera = from_front;
        camera.eye += shift;
        camera.target += shift;
        for (int notch = 0; notch < 1000; ++notch) {
            camera = dolly(camera, factor);
        }
        CAPTURE(factor, shift.x, distance_of(camera));
        CHECK(is_sound(camera));
        CHECK(distance_of(camera) > 0.0);
        CHECK(is_sound(orbit(camera, {0.3, -0.2})));
    }
}

TEST_CASE("a camera that is nearer than a zoom would go can still zoom out", "[window]") {
    Camera camera{{1000.0f, 0.0f, 1e-3f}, {1000.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 40.0f};
    check_near(dolly(camera, 2.0).eye, camera.eye);
    check_near(dolly(camera, 0.5).eye, {1000.0f, 0.0f, 2e-3f});
}

TEST_CASE("an orbit keeps the target and its distance", "[window]") {
    REQUIRE(rc::check("orbit keeps the distance", [] {
        const Camera camera = random_camera();
        const Camera turned = orbit(camera, random_move(1.0));
        RC_ASSERT(turned.target == camera.target);
        RC_ASSERT(std::abs(distance_of(turned) - distance_of(camera)) <= rounding_of(camera));
        RC_ASSERT(is_sound(turned));
    }));
}

TEST_CASE("an orbit by the opposite move returns to where it began", "[window]") {
    REQUIRE(rc::check("orbit returns", [] {
        const Camera camera = random_camera();
        const glm::dvec2 move = random_move(1.0);
        const Camera returned = orbit(orbit(camera, move), -move);
        // The eye there is off by e, and its frame by 2e / distance, which turns the way back
        // aside by twice as much at each end: 4e. With the last rounding: 6e.
        RC_ASSERT(glm::distance(glm::dvec3(returned.eye), glm::dvec3(camera.eye)) <=
                  6.0 * rounding_of(camera));
    }));
}

TEST_CASE("a pan keeps the direction and takes the target along with the mouse", "[window]") {
    REQUIRE(rc::check("pan keeps the direction", [] {
        const Camera camera = random_camera();
        const glm::dvec2 move = random_move(0.5);
        const double aspect_ratio = random_number(0.5, 2.0);
        const Camera moved = pan(camera, move, aspect_ratio);
        RC_ASSERT(is_sound(moved));
        // Eye and target are rounded each, before and after.
        const double rounding = 2.0 * (rounding_of(camera) + rounding_of(moved));
        RC_ASSERT(glm::distance(to_target(moved), to_target(camera)) <= rounding);

        // The old target, seen by the new camera, in windows from the middle.
        const glm::dvec3 sight = sight_of(moved);
        const glm::dvec3 right = glm::normalize(glm::cross(sight, glm::dvec3(camera.up)));
        const glm::dvec3 up = glm::cross(right, sight);
        const glm::dvec3 seen = glm::dvec3(camera.target) - glm::dvec3(moved.eye);
        const double angle = glm::radians(double(camera.vertical_field_of_view));
        const double height = 2.0 * distance_of(moved) * std::tan(angle / 2.0);
        // The frame turns by rounding / distance, and by ten times that where up is 8 degrees from
        // the line of sight (the nearest that a random camera has).
        const double tolerance =
            (rounding + 10.0 * rounding * (1.0 + height / distance_of(moved))) / height;
        RC_ASSERT(std::abs(glm::dot(seen, right) / height / aspect_ratio - move.x) <= tolerance);
        RC_ASSERT(std::abs(glm::dot(seen, up) / height - move.y) <= tolerance);
    }));
}

TEST_CASE("pan and dolly and roll are taken back by their opposites", "[window]") {
    REQUIRE(rc::check("opposites", [] {
        const Camera camera = random_camera();
        const glm::dvec3 eye(camera.eye);
        const glm::dvec2 move = random_move(0.5);
        const Camera there = pan(camera, move, 1.5);
        const Camera panned = pan(there, -move, 1.5);
        // The way is as long as the window is wide; its frame is off as above.
        const double way = glm::distance(glm::dvec3(there.eye), eye);
        const double rounding = 2.0 * (rounding_of(camera) + rounding_of(there));
        RC_ASSERT(glm::distance(glm::dvec3(panned.eye), eye) <=
                  rounding * (2.0 + 2.0 * way / distance_of(camera)));

        const double factor = std::pow(1.1, random_number(-10.0, 10.0));
        const Camera zoomed = dolly(camera, factor);
        // The rounding of the eye where it was nearer is magnified on the way back.
        RC_ASSERT(glm::distance(glm::dvec3(dolly(zoomed, 1.0 / factor).eye), eye) <=
                  rounding_of(camera) + std::max(1.0, factor) * rounding_of(zoomed));

        const double angle = random_number(-3.0, 3.0);
        const Camera level = roll(camera, 0.0);
        const Camera rolled = roll(roll(camera, angle), -angle);
        RC_ASSERT(rolled.target == camera.target);
        // Eye and up are rounded twice; up feels the eye's rounding through the line of sight.
        RC_ASSERT(glm::distance(glm::dvec3(rolled.eye), eye) <= 2.0 * rounding_of(camera));
        RC_ASSERT(glm::distance(rolled.up, level.up) <=
                  4.0 * rounding_of(camera) / distance_of(camera) + std::ldexp(1.0, -21));
    }));
}
