#include "whitted_checks.h"

#include <algorithm>

using namespace raysteps;

TEST_CASE("a mirror shows what stands in front of it only if a bounce is left",
          "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = {1.0f, 1.0f, 1.0f};
    add_wall(scene, 0.0f, mirror_material({0.5f, 0.25f, 1.0f}));
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
    check_color(middle_color(scene, 1), {0.5f, 0.25f, 1.0f});
    add_wall(scene, 10.0f, shining_material({2.0f, 4.0f, 8.0f}));
    check_color(middle_color(scene, 0), glm::vec3(0.0f));
    check_color(middle_color(scene, 1), {1.0f, 1.0f, 8.0f});
    check_color(middle_color(scene, 64), {1.0f, 1.0f, 8.0f});
}

TEST_CASE("a mirror with a diffuse colour shows both", "[reference][whitted]") {
    Scene scene = lit_wall();
    scene.materials[0].specular = glm::vec3(0.5f);
    scene.materials[0].illumination_model = 3;
    scene.background = glm::vec3(0.5f);
    check_color(middle_color(scene, 0), glm::vec3(0.4f));
    check_color(middle_color(scene, 1), glm::vec3(0.65f));
}

TEST_CASE("two mirrors that face each other end at the limit of bounces", "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = glm::vec3(100.0f); // never seen
    Material mirror = mirror_material(glm::vec3(0.5f));
    mirror.emission = {1.0f, 0.0f, 2.0f};
    add_wall(scene, 0.0f, mirror);
    add_wall(scene, 10.0f, mirror);
    check_color(middle_color(scene, 0), {1.0f, 0.0f, 2.0f});
    check_color(middle_color(scene, 1), {1.5f, 0.0f, 3.0f});
    check_color(middle_color(scene, 2), {1.75f, 0.0f, 3.5f});
    check_color(middle_color(scene, 64), {2.0f, 0.0f, 4.0f}); // short of it by 2^-64
    check_color(middle_color(scene, 1000), {2.0f, 0.0f, 4.0f});
}

TEST_CASE("a mirror reflects about the shading normal as long as that stays above the surface",
          "[reference][whitted]") {
    Scene scene = empty_scene();
    scene.background = {0.0f, 1.0f, 0.0f};
    add_wall(scene, 0.0f, mirror_material(glm::vec3(1.0f)));
    // Red, at x = 10, from below to far above.
    add_triangle(scene, {{10, -90, -40}, {10, 90, -40}, {10, 0, 90}}, {-1, 0, 0},
                 shining_material({1.0f, 0.0f, 0.0f}));
    const auto tilt = [&](const glm::vec3& normal) {
        std::fill(scene.normals.begin(), scene.normals.begin() + 3, normal);
    };
    tilt({0.6f, 0.0f, 0.8f}); // (0, 0, -1) goes to (0.96, 0, 0.28)
    check_color(middle_color(scene, 1), {1.0f, 0.0f, 0.0f});
    tilt({0.8f, 0.0f, 0.6f}); // (0.96, 0, -0.28) would go below: (0, 0, 1) instead
    check_color(middle_color(scene, 1), {0.0f, 1.0f, 0.0f});
}
