#include "brute_force_checks.h"

#include <cmath>

using namespace raysteps;

TEST_CASE("in double a ray down onto the unit triangle has the t and u and v of the hand",
          "[reference][brute]") {
    const ReferenceHit hit = nearest_hit(down_at(0.25f, 0.5f), unit_triangle);
    CHECK(hit.triangle == 0);
    CHECK(hit.t == 2.0);
    CHECK(hit.u == 0.25);
    CHECK(hit.v == 0.5);
    const ReferenceHit miss = nearest_hit(down_at(-0.5f, 0.5f), unit_triangle);
    CHECK(miss.triangle == no_triangle);
    CHECK(miss.t == double{infinity});
}

TEST_CASE("in double a ray along each axis and from both sides has the same answer",
          "[reference][brute]") {
    const int axis = GENERATE(0, 1, 2);
    const float side = GENERATE(-1.0f, 1.0f);
    const auto turned = [&](float x, float y, float z) {
        glm::vec3 point(0.0f);
        point[(axis + 1) % 3] = x;
        point[(axis + 2) % 3] = y;
        point[axis] = z;
        return point;
    };
    const Corners corners{turned(0, 0, 0), turned(1, 0, 0), turned(0, 1, 0)};
    const Ray ray{turned(0.25f, 0.5f, 2 * side), turned(0, 0, -side), 0.0f, infinity};
    const ReferenceHit hit = nearest_hit(ray, corners);
    CHECK(hit.t == 2.0);
    CHECK(hit.u == 0.25);
    CHECK(hit.v == 0.5);
}

TEST_CASE("in double the edges and the corners belong to the triangle", "[reference][brute]") {
    CHECK(is_hit_on_unit_triangle(down_at(0.5f, 0.0f)));
    CHECK(is_hit_on_unit_triangle(down_at(0.0f, 0.5f)));
    CHECK(is_hit_on_unit_triangle(down_at(0.5f, 0.5f)));
    CHECK(is_hit_on_unit_triangle(down_at(0.0f, 0.0f)));
    CHECK(is_hit_on_unit_triangle(down_at(1.0f, 0.0f)));
    CHECK(is_hit_on_unit_triangle(down_at(0.0f, 1.0f)));
    CHECK_FALSE(is_hit_on_unit_triangle(down_at(0.5f, std::nextafter(0.5f, 1.0f))));
}

TEST_CASE("in double t_min and t_max belong to the ray", "[reference][brute]") {
    Ray ray = down_at(0.25f, 0.25f);
    ray.t_min = 2.0f;
    ray.t_max = 2.0f;
    CHECK(is_hit_on_unit_triangle(ray));
    ray.t_min = std::nextafter(2.0f, 3.0f);
    ray.t_max = infinity;
    CHECK_FALSE(is_hit_on_unit_triangle(ray));
    ray.t_min = 0.0f;
    ray.t_max = std::nextafter(2.0f, 1.0f);
    CHECK_FALSE(is_hit_on_unit_triangle(ray));
}

TEST_CASE("in double a ray through the diagonal hits the quad", "[reference][brute][T4]") {
    const Ray ray{{0, 0, 10}, {0.30458447f, 0.30458447f, -0.9024725f}, 0.0f, infinity};
    CHECK(is_hit(ray, {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}}));
    CHECK(is_hit(ray, {{-5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}));
}

TEST_CASE("in double of equally near triangles the smallest index wins", "[reference][brute]") {
    Corners corners{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    for (int copy = 0; copy < 1000; ++copy) {
        const bool reversed = copy % 2 == 0;
        corners.insert(corners.end(),
                       {glm::vec3(0, 0, 0), reversed ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0),
                        reversed ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)});
    }
    CHECK(nearest_hit(down_at(0.25f, 0.5f), corners).triangle == 1);
}
