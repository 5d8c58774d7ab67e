#include "basics/text.h"
#include "program/options.h"
#include "scene/camera_text.h"

#include "catch.h"
#include "support/error_of.h"

using namespace raysteps;

namespace {

const Camera start{{0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 33.0f};

std::string sentence_about_camera(const std::string& text) {
    return error_of([&] { parse_camera(text, start); });
}

} // namespace

TEST_CASE("a size is two numbers of pixels or one for a square", "[command]") {
    CHECK(parse_size("640x480").width == 640);
    CHECK(parse_size("640x480").height == 480);
    CHECK(parse_size("512").width == 512);
    CHECK(parse_size("512").height == 512);
    CHECK(parse_size("1x16384").height == 16384);
}

TEST_CASE("a size that cannot be used is refused with its text", "[command]") {
    for (const std::string text :
         {"", "x", "0x5", "5x0", "-4x4", "+4x4", "4x", "x4", "4x4x4", "ax4", "4X4", " 4x4", "4x4 ",
          "4.5x4", "16385x1", "99999", "99999999999x1", "1e3x1", "0x10x1"}) {
        const std::string sentence = error_of([&] { parse_size(text); });
        CAPTURE(text);
        CHECK(sentence ==
              "--size " + text + ": a size is WIDTHxHEIGHT, as in 640x480, each from 1 to 16384.");
    }
}

TEST_CASE("a camera of six numbers keeps the angle of the start", "[command]") {
    const Camera camera = parse_camera("1,2,3,-4,.5,6e1", start);
    CHECK(camera.eye == glm::vec3(1.0f, 2.0f, 3.0f));
    CHECK(camera.target == glm::vec3(-4.0f, 0.5f, 60.0f));
    CHECK(camera.up == start.up);
    CHECK(camera.vertical_field_of_view == 33.0f);
}

TEST_CASE("a camera of seven numbers has its own angle", "[command]") {
    CHECK(parse_camera("0,0,5,0,0,0,90", start).vertical_field_of_view == 90.0f);
    CHECK(parse_camera("0,0,5,0,0,0,179.9", start).vertical_field_of_view == 179.9f);
}

TEST_CASE("a camera of ten numbers has its own angle and up", "[command]") {
    const Camera camera = parse_camera("0,0,5,0,0,0,20,1,0,0", start);
    CHECK(camera.vertical_field_of_view == 20.0f);
    CHECK(camera.up == glm::vec3(1.0f, 0.0f, 0.0f));
}

TEST_CASE("a camera that looks along its up calls another direction up", "[command]") {
    CHECK(parse_camera("0,5,0,0,0,0", start).up == glm::vec3(0.0f, 0.0f, -1.0f));
    CHECK(parse_camera("0,-5,0,0,0,0", start).up == glm::vec3(0.0f, 0.0f, -1.0f));
    Camera lying = start;
    lying.up = {1.0f, 0.0f, 0.0f};
    CHECK(parse_camera("5,0,0,0,0,0", lying).up == glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST_CASE("a camera that is not six or seven or ten numbers is refused", "[command]") {
    for (const std::string text :
         {"", "1", "1,2,3,4,5", "1,2,3,4,5,6,7,8", "1,2,3,4,5,6,7,8,9", "1,2,3,4,5,6,7,8,9,10,11",
          "1,2,3,4,5,", "1,2,3,4,5,x", "1,2,3,4,5,nan", "inf,2,3,4,5,6", "1;2;3;4;5;6",
          "1, 2, 3, 4, 5, 6", "1e39,2,3,4,5,6", "1 2 3 4 5 6"}) {
        CAPTURE(text);
        CHECK_THAT(sentence_about_camera(text),
                   starts_with_text("--camera " + text + ": a camera is six numbers, eye x,y,z"));
    }
}

TEST_CASE("a camera without a direction or with a wrong angle or up is refused", "[command]") {
    CHECK(sentence_about_camera("1,2,3,1,2,3") ==
          "--camera 1,2,3,1,2,3: eye and target are the same point. Move one of them.");
    for (const std::string angle : {"0", "-40", "180", "400"}) {
        CHECK(sentence_about_camera("0,0,5,0,0,0," + angle) ==
              "--camera 0,0,5,0,0,0," + angle +
                  ": the field of view is over 0 and under 180 degrees. Take another.");
    }
    for (const std::string up : {"0,0,1", "0,0,-2", "0,0,0"}) {
        CHECK(sentence_about_camera("0,0,5,0,0,0,40," + up) ==
              "--camera 0,0,5,0,0,0,40," + up +
                  ": up lies in the direction of view. Take another up.");
    }
}

TEST_CASE("a context is one of four names", "[command]") {
    CHECK(parse_context("auto") == ContextKind::automatic);
    CHECK(parse_context("osmesa") == ContextKind::osmesa);
    CHECK(parse_context("egl") == ContextKind::egl);
    CHECK(parse_context("window") == ContextKind::window);
    for (const std::string text : {"", "EGL", "eg", "glx"}) {
        const std::string sentence = error_of([&] { parse_context(text); });
        CHECK_THAT(sentence, starts_with_text("--context " + text + ": there is no such choice."));
        CHECK_THAT(sentence, contains_text(" Take one of auto, osmesa, egl, window."));
    }
}
