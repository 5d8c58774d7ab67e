#include "reference/reference_ray.h"

#include "catch.h"

#include <glm/geometric.hpp>

using namespace raysteps;

namespace {

// 90 degrees: at distance 1 the picture is 2 high.
const Camera camera{
    .eye = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 1, 0}, .vertical_field_of_view = 90.0f};

// tan(45 degrees) and the axes are rounded a few times: 8 roundings of at most 3, in double.
constexpr double tolerance = 8.0 * 3.0 / 9007199254740992.0;

void check_direction(const ReferenceRay& ray, const glm::dvec3& expected) {
    CHECK(ray.origin == glm::dvec3(0, 0, 5));
    CHECK(glm::length(ray.direction - expected) <= tolerance);
}

} // namespace

TEST_CASE("the ray of a single pixel goes from the eye to the target", "[reference][camera]") {
    check_direction(reference_ray(camera, 1, 1, 0, 0), {0, 0, -1});
}

TEST_CASE("column 0 is left and row 0 is the top", "[reference][camera]") {
    check_direction(reference_ray(camera, 4, 2, 0, 0), {-1.5, 0.5, -1});
    check_direction(reference_ray(camera, 4, 2, 3, 0), {1.5, 0.5, -1});
    check_direction(reference_ray(camera, 4, 2, 0, 1), {-1.5, -0.5, -1});
    check_direction(reference_ray(camera, 4, 2, 2.25, 1), {0.75, -0.5, -1});
}

TEST_CASE("a ray in double is the ray in float without rounding", "[reference]") {
    const Ray ray{{0.1f, 0.2f, 0.3f}, {1, 2, 3}, 0.5f, 0.7f};
    const ReferenceRay same = reference_ray(ray);
    CHECK(same.origin == glm::dvec3(0.1f, 0.2f, 0.3f));
    CHECK(same.direction == glm::dvec3(1, 2, 3));
    CHECK(same.t_min == double{0.5f});
    CHECK(same.t_max == double{0.7f});
}
