#include "basics/random_numbers.h"
#include "catch.h"
#include "structure/kd_tree/kd_split.h"

using namespace raysteps;

namespace {

constexpr ExactBox unit_box{glm::dvec3(0.0), glm::dvec3(1.0)};

// Bounds are rounded outwards by one number or two; near 1 that is less than 2.4e-7.
void check_bounds(const Box& bounds, const glm::vec3& lower, const glm::vec3& upper) {
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        CHECK(bounds.lower[axis] < lower[axis]);
        CHECK(bounds.lower[axis] > lower[axis] - 2.4e-7f);
        CHECK(bounds.upper[axis] > upper[axis]);
        CHECK(bounds.upper[axis] < upper[axis] + 2.4e-7f);
    }
}

} // namespace

TEST_CASE("a triangle inside the box keeps its bounds", "[05][clip]") {
    check_bounds(clipped_bounds({glm::vec3(0.25f, 0.5f, 0.5f), glm::vec3(0.75f, 0.25f, 0.5f),
                                 glm::vec3(0.5f, 0.5f, 0.875f)},
                                unit_box, 0.0),
                 {0.25f, 0.25f, 0.5f}, {0.75f, 0.5f, 0.875f});
}

TEST_CASE("the corner of a triangle that looks into the box is bounded by what is inside",
          "[05][clip]") {
    // The line x + y = 0.5 from (2, -1.5) to (-1.5, 2) and a corner far out: inside are the points
    // between the line and the box's corner (1, 1).
    check_bounds(clipped_bounds({glm::vec3(2.0f, -1.5f, 0.5f), glm::vec3(-1.5f, 2.0f, 0.5f),
                                 glm::vec3(-4.0f, -4.0f, 0.5f)},
                                unit_box, 0.0),
                 {0.0f, 0.0f, 0.5f}, {0.5f, 0.5f, 0.5f});
}

TEST_CASE("a triangle whose bounds overlap the box may not meet it", "[05][clip]") {
    // x + y >= 2.5 for all of it, and both reach down to below 1.
    CHECK(is_empty(clipped_bounds(
        {glm::vec3(2.0f, 0.5f, 0.5f), glm::vec3(0.5f, 2.0f, 0.5f), glm::vec3(2.0f, 2.0f, 0.5f)},
        unit_box, 0.0)));
}

TEST_CASE("a triangle that touches the box meets it in a point", "[05][clip]") {
    check_bounds(clipped_bounds({glm::vec3(1.0f, 1.0f, 1.0f), glm::vec3(2.0f, 1.0f, 1.0f),
                                 glm::vec3(1.0f, 2.0f, 2.0f)},
                                unit_box, 0.0),
                 {1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f});
}

TEST_CASE("bounds grow by the padding", "[05][clip]") {
    check_bounds(clipped_bounds({glm::vec3(0.25f), glm::vec3(0.75f, 0.25f, 0.25f),
                                 glm::vec3(0.25f, 0.75f, 0.25f)},
                                unit_box, 0.125),
                 {0.125f, 0.125f, 0.125f}, {0.875f, 0.875f, 0.375f});
}

TEST_CASE("points of a triangle in the box lie in the clipped bounds", "[05][clip][property]") {
    const int seed = 41;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::array<glm::vec3, 3> triangle{3.0f * numbers.in_cube(), 3.0f * numbers.in_cube(),
                                                3.0f * numbers.in_cube()};
        const Box bounds = clipped_bounds(triangle, unit_box, 0.0);
        for (int k = 0; k < 8; ++k) {
            const double u = static_cast<double>(numbers.unit());
            const double v = (1.0 - u) * static_cast<double>(numbers.unit());
            const glm::dvec3 point = (1.0 - u - v) * glm::dvec3(triangle[0]) +
                                     u * glm::dvec3(triangle[1]) + v * glm::dvec3(triangle[2]);
            bool in_box = true;
            bool in_bounds = true;
            for (int axis = 0; axis < 3; ++axis) {
                in_box = in_box && point[axis] >= 0.0 && point[axis] <= 1.0;
                in_bounds = in_bounds && point[axis] >= static_cast<double>(bounds.lower[axis]) &&
                            point[axis] <= static_cast<double>(bounds.upper[axis]);
            }
            inside += in_box ? 1 : 0;
            if (in_box && !in_bounds) {
                FAIL("triangle " << i << " has a point in the box and outside the bounds");
            }
        }
    }
    CHECK(inside > 1000);
}
