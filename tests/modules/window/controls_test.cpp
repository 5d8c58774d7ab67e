#include "program/window/controls.h"

#include "catch.h"

using namespace raysteps;

namespace {

Controls controls_of_400x200() {
    Controls controls = start_controls(Camera{});
    controls.window_size = {400.0, 200.0};
    return move_cursor(controls, {100.0, 100.0});
}

} // namespace

TEST_CASE("the mouse moves the camera only while a button is held", "[window]") {
    const Controls still = move_cursor(controls_of_400x200(), {150.0, 100.0});
    CHECK(still.camera.eye == Camera{}.eye);
    const Controls held = press_button(still, Button::left, {});
    const Controls dragged = move_cursor(held, {200.0, 100.0});
    CHECK(dragged.camera.eye.x < 0.0f);
    const Controls released = release_button(dragged, Button::left);
    CHECK(move_cursor(released, {300.0, 30.0}).camera.eye == dragged.camera.eye);
}

TEST_CASE("the button pressed last drags until it is released itself", "[window]") {
    Controls controls = press_button(controls_of_400x200(), Button::left, {});
    controls = press_button(controls, Button::middle, {});
    CHECK(controls.motion == Motion::pan);
    controls = release_button(controls, Button::left);
    CHECK(controls.motion == Motion::pan);
    controls = release_button(controls, Button::middle);
    CHECK(controls.motion == Motion::none);
}

TEST_CASE("R returns to the first camera even from the middle of a drag", "[window]") {
    Controls controls = press_button(controls_of_400x200(), Button::left, {});
    controls = move_cursor(controls, {130.0, 170.0});
    CHECK(press_key(controls, 'r').camera.eye == Camera{}.eye);
}

TEST_CASE("S and C mean the camera at the time of the key", "[window]") {
    Controls controls = scroll(controls_of_400x200(), 1.0);
    const Camera then = controls.camera;
    controls = press_key(press_key(controls, 's'), 'c');
    controls = scroll(controls, 3.0);
    REQUIRE(controls.camera_to_save);
    REQUIRE(controls.camera_to_print);
    CHECK(controls.camera_to_save->eye == then.eye);
    CHECK(controls.camera_to_print->eye == then.eye);
    CHECK(controls.camera.eye != then.eye);
}

TEST_CASE("H shows and hides the help and asks for a redraw", "[window]") {
    Controls controls = controls_of_400x200();
    controls.must_redraw = false;
    controls = press_key(controls, 'h');
    CHECK(controls.help);
    CHECK(controls.must_redraw);
    CHECK_FALSE(press_key(controls, 'h').help);
}

TEST_CASE("Q closes and other letters do nothing", "[window]") {
    const Controls controls = controls_of_400x200();
    CHECK(press_key(controls, 'q').close);
    for (const char letter : {'a', 'x', '1', ' ', '\0', '\xc3'}) {
        const Controls same = press_key(controls, letter);
        CHECK_FALSE((same.close || same.help || same.camera_to_save || same.camera_to_print));
        CHECK(same.camera.eye == controls.camera.eye);
    }
}

TEST_CASE("other letters are for what a window offers, in their order", "[window]") {
    const Controls controls = press_key(press_key(controls_of_400x200(), 'w'), 'v', true);
    REQUIRE(controls.choice_keys.size() == 2);
    CHECK((controls.choice_keys[0].letter == 'w' && !controls.choice_keys[0].shift));
    CHECK((controls.choice_keys[1].letter == 'v' && controls.choice_keys[1].shift));
}

TEST_CASE("a click is a press and a release of the left button at one place", "[window]") {
    const Controls pressed = press_button(controls_of_400x200(), Button::left, {});
    const Controls clicked = release_button(move_cursor(pressed, {102.0, 99.0}), Button::left);
    REQUIRE(clicked.clicked);
    CHECK(*clicked.clicked == glm::dvec2(102.0, 99.0));
    CHECK_FALSE(release_button(move_cursor(pressed, {104.0, 100.0}), Button::left).clicked);
    const Controls shifted = press_button(controls_of_400x200(), Button::left, {.shift = true});
    CHECK_FALSE(release_button(shifted, Button::left).clicked);
}

TEST_CASE("over the panel the mouse is the panel's, until its button is released", "[window]") {
    Controls controls = press_key(controls_of_400x200(), 'h');
    controls.panel = {{50.0, 50.0}, {150.0, 150.0}};
    controls = press_button(controls, Button::left, {});
    controls = move_cursor(move_cursor(controls, {120.0, 100.0}), {300.0, 20.0});
    controls = release_button(controls, Button::left);
    CHECK(controls.camera.eye == Camera{}.eye);
    CHECK_FALSE(controls.clicked);
    REQUIRE(controls.panel_events.size() == 3); // of two moves the last
    CHECK(controls.panel_events[0].pressed);
    CHECK(controls.panel_events[1].place == glm::dvec2(300.0, 20.0));
    CHECK(controls.panel_events[1].pressed);
    CHECK_FALSE(controls.panel_events[2].pressed);
    // The wheel there is the panel's too, and beside it the camera's.
    CHECK(scroll(move_cursor(controls, {60.0, 60.0}), 1.0).camera.eye == Camera{}.eye);
    CHECK(scroll(controls, 1.0).camera.eye != Camera{}.eye);
}

TEST_CASE("each letter of the panel's lines is a key", "[window]") {
    for (const ControlLine& line : control_lines()) {
        if (line.letter != 0) {
            CHECK(press_key(controls_of_400x200(), line.letter).choice_keys.empty());
        }
    }
}
