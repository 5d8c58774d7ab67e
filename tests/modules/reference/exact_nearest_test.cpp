#include "reference/exact.h"

#include "catch.h"
#include "ray_families.h"
#include "rounding_bound.h"

#include <iostream>

using namespace raysteps;

namespace {

// Triangles of all sizes, the first five listed twice.
std::vector<glm::vec3> triangle_soup(RandomNumbers& numbers) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 middle = numbers.in_cube();
        const float size = std::ldexp(1.0f, -i / 4);
        for (int corner = 0; corner < 3; ++corner) {
            corners.push_back(middle + size * numbers.in_cube());
        }
    }
    const std::vector<glm::vec3> again(corners.begin(), corners.begin() + 15);
    corners.insert(corners.end(), again.begin(), again.end());
    return corners;
}

bool are_equal(const ReferenceHit& a, const ReferenceHit& b) {
    return a.t == b.t && a.u == b.u && a.v == b.v && a.triangle == b.triangle;
}

} // namespace

TEST_CASE("of two parallel triangles the nearer one is hit", "[reference][exact]") {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                         {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    const Ray down{{0.25f, 0.5f, 3}, {0, 0, -2}, 0.0f, 100.0f};
    const ReferenceHit hit = exact_nearest_hit(down, corners);
    CHECK(hit.triangle == 1);
    CHECK(hit.t == 1.0);
    CHECK(hit.u == 0.25);
    CHECK(hit.v == 0.5);
    const Ray up{{0.25f, 0.5f, -3}, {0, 0, 2}, 0.0f, 100.0f};
    CHECK(exact_nearest_hit(up, corners).triangle == 0);
    CHECK(exact_nearest_hit(up, corners).t == 1.5);
}

TEST_CASE("a miss has the t_max of the ray and no triangle", "[reference][exact]") {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Ray away{{0.25f, 0.5f, 3}, {0, 0, 1}, 0.0f, 100.0f};
    CHECK(are_equal(exact_nearest_hit(away, corners), {100.0, 0.0, 0.0, no_triangle}));
    CHECK(are_equal(exact_nearest_hit(away, {}), {100.0, 0.0, 0.0, no_triangle}));
}

TEST_CASE("of equally near triangles the smallest index wins", "[reference][exact]") {
    // Both halves of a quad meet the ray on their diagonal; then copies of them.
    const glm::vec3 a(-1, -1, 0);
    const glm::vec3 b(1, -1, 0);
    const glm::vec3 c(1, 1, 0);
    const glm::vec3 d(-1, 1, 0);
    const std::vector<glm::vec3> corners{b, a, d, a, b, c, a, c, d, a, c, b, a, b, c};
    const Ray ray{{0.3f, 0.3f, 7}, {0, 0, -0.3f}, 0.0f, 100.0f};
    CHECK(exact_nearest_hit(ray, corners).triangle == 1);
}

TEST_CASE("a third of a float apart is enough to tell which triangle is nearer",
          "[reference][exact]") {
    // t = 1/3 and t = 1/3 + 2^-149 / 3 are the same double, but not the same number.
    const float smallest = std::numeric_limits<float>::denorm_min();
    const std::vector<glm::vec3> corners{{0, 0, smallest}, {1, 0, smallest}, {0, 1, smallest},
                                         {0, 0, 0},        {1, 0, 0},        {0, 1, 0}};
    const Ray up{{0.25f, 0.25f, -1}, {0, 0, 3}, 0.0f, 100.0f};
    CHECK(exact_nearest_hit(up, corners).triangle == 1);
    const Ray down{{0.25f, 0.25f, 1}, {0, 0, -3}, 0.0f, 100.0f};
    CHECK(exact_nearest_hit(down, corners).triangle == 0);
}

TEST_CASE("the filter changes no answer", "[reference][exact]") {
    const int seed = 7;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<glm::vec3> corners = triangle_soup(numbers);
    int hits = 0;
    int skipped = 0;
    for (const Aim aim : {Aim::anywhere, Aim::at_edges, Aim::at_corners}) {
        const std::vector<Ray> rays = rays_at(mesh_of(corners), aim, 150, 2.0f, numbers);
        const std::vector<ReferenceHit> together = exact_nearest_hits(rays, corners);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ray& ray = rays[i];
            const ReferenceHit expected = exact_nearest_hit_unfiltered(ray, corners);
            REQUIRE(are_equal(exact_nearest_hit(ray, corners), expected));
            REQUIRE(are_equal(together[i], expected));
            hits += expected.triangle != no_triangle ? 1 : 0;
            for (int triangle = 0; triangle < 65; ++triangle) {
                skipped += surely_misses(ray, corners_of(triangle, corners)) ? 1 : 0;
            }
        }
    }
    std::cout << "exact: 450 rays, " << hits << " hits, the filter answers " << skipped << " of "
              << 450 * 65 << " questions, 0 different\n";
    CHECK(hits > 100);
    CHECK(skipped > 450 * 65 / 2); // else it saves nothing
}

TEST_CASE(
    "boxes around triangles lose no hit along their sides, of no size and of what is not finite",
    "[reference][exact]") {
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (const float scale : {0x1p-120f, 1.0f, 0x1p+80f}) {
        CAPTURE(scale);
        // A floor of 200 triangles has boxes without height; so has each of its lines of corners.
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 a = scale * glm::vec3(i % 10, 0, i / 10);
            const glm::vec3 b = a + scale * glm::vec3(1, 0, 0);
            const glm::vec3 c = a + scale * glm::vec3(1, 0, 1);
            const glm::vec3 d = a + scale * glm::vec3(0, 0, 1);
            corners.insert(corners.end(), {a, b, c, a, c, d});
        }
        corners[0].x = std::numeric_limits<float>::quiet_NaN();
        corners[10].y = std::numeric_limits<float>::infinity();
        std::vector<Ray> rays;
        for (int i = 0; i < 300; ++i) {
            const glm::vec3 target = corners[static_cast<std::size_t>(i * 7 % 600)];
            const glm::vec3 origin =
                i % 2 == 0 ? target + scale * glm::vec3(0, 3, 0) : scale * 5.0f * numbers.in_cube();
            rays.push_back({origin, target - origin, 0.0f, 10.0f});
        }
        const std::vector<ReferenceHit> together = exact_nearest_hits(rays, corners);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            CAPTURE(i);
            REQUIRE(are_equal(together[i], exact_nearest_hit_unfiltered(rays[i], corners)));
        }
    }
}

TEST_CASE("the filter never calls a hit a sure miss", "[reference][exact]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const std::vector<glm::vec3> corners = triangle_soup(numbers);
    for (int i = 0; i < 20000; ++i) {
        // Aimed along one triangle's edges and corners, in large and small coordinates.
        const int triangle = i % 65;
        const float scale = std::ldexp(1.0f, (i * 37) % 240 - 130);
        auto three = corners_of(triangle, corners);
        const float share = static_cast<float>(i % 9) / 8.0f;
        for (glm::vec3& corner : three) {
            corner *= scale;
        }
        const glm::vec3 target = three[0] + share * (three[1] - three[0]);
        const glm::vec3 origin = scale * 2.0f * numbers.in_cube();
        const Ray ray{origin, target - origin, 0.0f, std::numeric_limits<float>::infinity()};
        if (surely_misses(ray, three)) {
            CAPTURE(i);
            REQUIRE_FALSE(exact_intersection(ray, three).hit);
        }
    }
}

TEST_CASE("no ray from inside leaves a closed sphere", "[reference][exact][T1][T2]") {
    const int seed = 3;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Mesh sphere = shared_edge_sphere();
    REQUIRE(sphere.corners.size() == 4560);
    for (const Aim aim : {Aim::anywhere, Aim::at_edges, Aim::at_corners}) {
        const std::vector<Ray> rays = rays_at(sphere, aim, 2000, 0.9f, numbers);
        for (const ReferenceHit& hit : exact_nearest_hits(rays, sphere.corners)) {
            REQUIRE(hit.triangle != no_triangle);
        }
    }
}
