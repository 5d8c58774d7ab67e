#include "whitted_checks.h"

#include "basics/error.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

using namespace raysteps;

TEST_CASE("row 0 of the image is its top and column 0 its left", "[reference][whitted]") {
    Scene scene = empty_scene();
    add_triangle(scene, {{-1, 0.5f, 0}, {-1, 1.5f, 0}, {-2, 1, 0}}, {0, 0, 1},
                 shining_material(glm::vec3(1.0f)));
    // At distance 5 the picture is 3.64 high and wide, so a pixel is 0.91: this one is at
    // (-1.36, 1.36).
    scene.corners = {{-1.9f, 0.9f, 0}, {-0.9f, 0.9f, 0}, {-1.4f, 2.5f, 0}};
    const Image image = render_whitted(scene, 4, 4, {.max_bounces = 0});
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            const bool is_lit = row == 0 && column == 0;
            CAPTURE(row, column);
            check_color(image.at(column, row), glm::vec3(is_lit ? 1.0f : 0.0f));
        }
    }
}

TEST_CASE("a surface never shadows itself however far out and however grazing the view",
          "[reference][whitted]") {
    const float offset = GENERATE(0.0f, 1e3f, 1e6f);
    const float height = GENERATE(5.0f, 0.01f);
    CAPTURE(offset, height);
    Scene scene = empty_scene();
    add_wall(scene, 0.0f, diffuse_material(glm::vec3(1.0f)));
    for (glm::vec3& corner : scene.corners) {
        corner += glm::vec3(offset, -offset, offset);
    }
    scene.camera.target = glm::vec3(offset, -offset, offset);
    scene.camera.eye =
        scene.camera.target + glm::vec3(0.0f, -5.0f, std::max(height, offset / 1e6f));
    scene.lights = {{.position = scene.camera.eye, .color = glm::vec3(1.0f)}};
    scene.background = glm::vec3(1.0f);
    for (const glm::vec3& color : render_whitted(scene, 48, 48, {.max_bounces = 0}).pixels) {
        REQUIRE(color.x > 0.0f);
    }
}

TEST_CASE("only pixels beside an edge are sensitive to where their ray goes",
          "[reference][whitted]") {
    const glm::vec3 side =
        GENERATE(glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, -1, 0));
    CAPTURE(side.x, side.y);
    Scene scene = empty_scene();
    scene.background = glm::vec3(1.0f);
    // All to one side of the middle of the picture, from 2^-10 pixels on. The eye is 5 away.
    const float pixel = 2.0f * 5.0f * std::tan(glm::radians(20.0f)) / 17.0f;
    const glm::vec3 along(side.y, side.x, 0.0f);
    const glm::vec3 start = side * (pixel / 1024.0f);
    add_triangle(scene, {start - 50.0f * along, start + 50.0f * along, 90.0f * side}, {0, 0, 1},
                 shining_material(glm::vec3(0.0f)));
    const std::vector<double> sensitivity =
        whitted_sensitivity(scene, 17, 17, {.max_bounces = 0}, 1.0 / 256.0);
    for (int i = 0; i < 17 * 17; ++i) {
        const int across = side.x != 0.0f ? i % 17 : i / 17;
        REQUIRE(sensitivity[static_cast<std::size_t>(i)] == (across == 8 ? 1.0 : 0.0));
    }
    for (const double change :
         whitted_sensitivity(scene, 17, 17, {.max_bounces = 0}, 1.0 / 4096.0)) {
        REQUIRE(change == 0.0);
    }
}

TEST_CASE("a picture without pixels or with too many bounces is refused", "[reference][whitted]") {
    const Scene scene = empty_scene();
    CHECK_THROWS_AS(render_whitted(scene, 0, 4, {.max_bounces = 1}), InputError);
    CHECK_THROWS_AS(render_whitted(scene, 4, -1, {.max_bounces = 1}), InputError);
    CHECK_THROWS_AS(render_whitted(scene, 4, 4, {.max_bounces = -1}), InputError);
    CHECK_THROWS_AS(render_whitted(scene, 4, 4, {.max_bounces = 1001}), InputError);
    CHECK_THROWS_AS(whitted_sensitivity(scene, 0, 4, {.max_bounces = 1}, 0.1), InputError);
}
