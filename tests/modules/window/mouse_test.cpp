#include "program/window/controls.h"

#include "cameras.h"
#include "catch.h"

using namespace raysteps;

TEST_CASE("buttons and modifiers mean what they mean to VTK", "[window]") {
    const Modifiers none;
    const Modifiers shift{.shift = true, .control = false};
    const Modifiers control{.shift = false, .control = true};
    const Modifiers both{.shift = true, .control = true};
    CHECK(motion_of(Button::left, none) == Motion::orbit);
    CHECK(motion_of(Button::left, shift) == Motion::pan);
    CHECK(motion_of(Button::left, control) == Motion::roll);
    CHECK(motion_of(Button::left, both) == Motion::dolly);
    for (const Modifiers& modifiers : {none, shift, control, both}) {
        CHECK(motion_of(Button::middle, modifiers) == Motion::pan);
        CHECK(motion_of(Button::right, modifiers) == Motion::dolly);
    }
}

TEST_CASE("the mouse comes in pixels with y downward", "[window]") {
    const glm::dvec2 size{400.0, 200.0};
    const Camera start;
    // 180 of 400 pixels are 90 degrees.
    const Camera right = drag(start, Motion::orbit, {10.0, 50.0}, {190.0, 50.0}, size);
    CHECK(right.eye.x == Approx(-5.0f));
    const Camera up = drag(start, Motion::orbit, {10.0, 150.0}, {10.0, 60.0}, size);
    CHECK(up.eye.y == Approx(-5.0f));
    // A tenth of the window's height is VTK's 1.1 ^ 2.
    const Camera nearer = drag(start, Motion::dolly, {10.0, 50.0}, {10.0, 30.0}, size);
    CHECK(nearer.eye.z == Approx(5.0 / 1.21));
    // From the right of the middle to above it: a quarter, counter-clockwise.
    const Camera tilted = drag(start, Motion::roll, {300.0, 100.0}, {200.0, 20.0}, size);
    CHECK(tilted.up.x == Approx(1.0f));
    CHECK(drag(start, Motion::none, {0.0, 0.0}, {9.0, 9.0}, size).eye == start.eye);
}

TEST_CASE("a notch of the wheel is two of the zoom's powers", "[window]") {
    CHECK(turn_wheel(Camera{}, 1.0).eye.z == Approx(5.0 / 1.21));
    CHECK(turn_wheel(Camera{}, -2.0).eye.z == Approx(5.0 * 1.21 * 1.21));
}

TEST_CASE("no drag in any window makes the camera unsound", "[window]") {
    REQUIRE(rc::check("drags", [] {
        const Camera camera = random_camera();
        const auto motion =
            *rc::gen::element(Motion::orbit, Motion::roll, Motion::pan, Motion::dolly);
        // A minimised window has the size 0, and a drag goes on outside of it.
        const glm::dvec2 size{*rc::gen::inRange(0, 500), *rc::gen::inRange(0, 500)};
        const Camera moved = drag(camera, motion, random_move(1000.0), random_move(1000.0), size);
        RC_ASSERT(is_finite(moved.eye) && is_finite(moved.target) && is_finite(moved.up));
        RC_ASSERT(moved.eye != moved.target);
    }));
}
