#include "catch.h"
#include "mirror/walks.h"
#include "scene/view.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

using namespace raysteps;

namespace {

Camera camera_along_minus_z(float angle) {
    Camera camera;
    camera.eye = {1.0f, 2.0f, 3.0f};
    camera.target = {1.0f, 2.0f, -4.0f};
    camera.vertical_field_of_view = angle;
    return camera;
}

} // namespace

TEST_CASE("at 90 degrees the view rectangle is as high as twice its distance", "[01][view]") {
    const View view = view_of(camera_along_minus_z(90.0f), 1.5);
    CHECK(view.eye == glm::vec3(1.0f, 2.0f, 3.0f));
    CHECK(view.lower_left.x == Approx(-1.5f));
    CHECK(view.lower_left.y == Approx(-1.0f));
    CHECK(view.lower_left.z == Approx(-1.0f));
    CHECK(view.right.x == Approx(3.0f));
    CHECK(view.up.y == Approx(2.0f));
}

TEST_CASE("the field of view is the angle between the middles of the lower and upper edge",
          "[01][view]") {
    for (const float angle : {1.0f, 40.0f, 90.0f, 179.0f}) {
        CAPTURE(angle);
        Camera camera;
        camera.eye = {3.0f, -2.0f, 7.0f};
        camera.target = {-1.0f, 0.5f, 0.25f};
        camera.vertical_field_of_view = angle;
        const View view = view_of(camera, 2.0);
        const glm::dvec3 lower = glm::dvec3(view.lower_left) + 0.5 * glm::dvec3(view.right);
        const glm::dvec3 upper = lower + glm::dvec3(view.up);
        const double between =
            std::atan2(glm::length(glm::cross(lower, upper)), glm::dot(lower, upper));
        // Each end is rounded by at most 2^-24 of its length: two ends and two sums, in radians.
        CHECK(std::abs(between - glm::radians(static_cast<double>(angle))) < 6.0 * 0x1p-24);
    }
}

TEST_CASE("the primary ray of the middle goes to the target", "[01][view]") {
    Camera camera;
    camera.eye = {3.0f, -2.0f, 7.0f};
    camera.target = {-1.0f, 0.5f, 0.25f};
    using Mirror = mirror::walks::every_triangle<float>;
    Mirror mirror{};
    const View view = view_of(camera, 1.0);
    const auto ray =
        mirror.primary_ray({view.eye, view.lower_left, view.right, view.up}, 0.5f, 0.5f);
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 to_target = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const double off = glm::length(glm::cross(direction, to_target)) /
                       (glm::length(direction) * glm::length(to_target));
    // lower_left, right and up are each rounded once, and summed twice: six roundings of numbers
    // under 1.
    CHECK(off < 6.0 * 0x1p-24);
    CHECK(ray.t_min == 0.0f);
}
