#include "reference/allowed_answers.h"

#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "hard_cases/meshes.h"
#include "reference/exact.h"
#include "scene/shapes.h"

#include <algorithm>

using namespace raysteps;

namespace {

constexpr auto anywhere = AnswerRules::Origin::anywhere;

const std::vector<glm::vec3> square = quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}).corners;

Ray down_from_one(float x, float y) {
    return {{x, y, 1}, {0, 0, -1}, 0.0f, no_end};
}

std::vector<int> triangles_of(const AllowedAnswer& answer) {
    std::vector<int> triangles;
    for (const AllowedHit& hit : answer.hits) {
        triangles.push_back(hit.triangle);
    }
    return triangles;
}

bool allows(const AllowedAnswer& answer, const ReferenceHit& hit) {
    if (hit.triangle == no_triangle) {
        return answer.miss;
    }
    return std::any_of(answer.hits.begin(), answer.hits.end(), [&](const AllowedHit& one) {
        return one.triangle == hit.triangle && static_cast<double>(one.t_least) <= hit.t &&
               hit.t <= static_cast<double>(one.t_most);
    });
}

} // namespace

TEST_CASE("a ray at the middle of a triangle may name it alone, at its t", "[reference][exact]") {
    const AllowedAnswer answer = AnswerRules(square).allowed(down_from_one(0.75f, 0.25f), anywhere);
    CHECK_FALSE(answer.miss);
    CHECK_FALSE(answer.anything);
    REQUIRE(triangles_of(answer) == std::vector{0});
    // The reach is 1, along z: the corners lie 1 below.
    CHECK(answer.hits[0].t_least == 1.0f - 0x1p-19f);
    CHECK(answer.hits[0].t_most == 1.0f + 0x1p-19f);
}

TEST_CASE("a ray beside all triangles may only miss", "[reference][exact]") {
    const AllowedAnswer answer = AnswerRules(square).allowed(down_from_one(1.001f, 0.5f), anywhere);
    CHECK(answer.miss);
    CHECK(answer.hits.empty());
}

TEST_CASE("at a border a ray may hit or miss, and at a shared edge it must hit",
          "[reference][exact]") {
    const AnswerRules rules(square);
    const AllowedAnswer border = rules.allowed(down_from_one(1.0f + 0x1p-20f, 0.5f), anywhere);
    CHECK(border.miss);
    CHECK(triangles_of(border) == std::vector{0});
    for (const float beside : {0.0f, 0x1p-20f, -0x1p-20f}) {
        const AllowedAnswer shared = rules.allowed(down_from_one(0.5f + beside, 0.5f), anywhere);
        CHECK_FALSE(shared.miss);
        CHECK(triangles_of(shared) == std::vector{0, 1});
    }
}

TEST_CASE("neither the winding of triangles nor copies of them open an edge",
          "[reference][exact]") {
    std::vector<glm::vec3> turned = square;
    std::swap(turned[4], turned[5]);
    CHECK_FALSE(AnswerRules(turned).allowed(down_from_one(0.5f, 0.5f), anywhere).miss);
    const Mesh thrice = tripled({square, {}});
    const AllowedAnswer answer =
        AnswerRules(thrice.corners).allowed(down_from_one(0.5f, 0.5f), anywhere);
    CHECK_FALSE(answer.miss);
    CHECK(answer.hits.size() == 6);
}

TEST_CASE("what lies behind a surface is not allowed, and what lies in it is",
          "[reference][exact]") {
    const Mesh two = join({square, {}}, quad({0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}));
    const AnswerRules rules(two.corners);
    CHECK(triangles_of(rules.allowed(down_from_one(0.5f, 0.5f), anywhere)) == std::vector{0, 1});
    Ray behind = down_from_one(0.75f, 0.25f);
    behind.t_min = 1.5f;
    CHECK(triangles_of(rules.allowed(behind, anywhere)) == std::vector{2});
    // At a border one may fall through to the next.
    const Mesh lower = join({square, {}}, quad({0, 0, -1}, {2, 0, -1}, {2, 1, -1}, {0, 1, -1}));
    const AllowedAnswer border =
        AnswerRules(lower.corners).allowed(down_from_one(1.0f, 0.5f), anywhere);
    CHECK_FALSE(border.miss);
    CHECK(triangles_of(border).size() == 3);
}

TEST_CASE("an end of the ray within the room of a hit allows both", "[reference][exact]") {
    const AnswerRules rules(square);
    Ray ray = down_from_one(0.75f, 0.25f);
    ray.t_max = 1.0f;
    CHECK(rules.allowed(ray, anywhere).miss);
    CHECK(rules.allowed(ray, anywhere).hits.size() == 1);
    CHECK(rules.allowed(ray, anywhere).hits[0].t_most == 1.0f);
    ray.t_max = 0.999f;
    CHECK(rules.allowed(ray, anywhere).hits.empty());
    ray.t_max = 1.001f;
    CHECK_FALSE(rules.allowed(ray, anywhere).miss);
}

TEST_CASE("from inside a closed mesh no miss is allowed, and of no ray anything is",
          "[reference][exact]") {
    const Mesh ball = sphere(glm::vec3(0.0f), 1.0f, 2);
    const AnswerRules rules(ball.corners);
    RandomNumbers numbers(5);
    for (const Ray& ray : corner_aimed_rays(numbers, ball, glm::vec3(0.4f), 50)) {
        CHECK_FALSE(rules.allowed(ray, AnswerRules::Origin::inside).miss);
        CHECK_FALSE(rules.allowed(ray, anywhere).miss); // the corner is closed all around
        CHECK(rules.allowed(ray, anywhere).hits.size() >= 5);
    }
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    CHECK(rules.allowed({{0, 0, 0}, {0, not_a_number, 1}, 0.0f, no_end}, anywhere).anything);
    CHECK(rules.allowed({{0, 0, 0}, {0, 0, 0}, 0.0f, no_end}, anywhere).anything);
}

TEST_CASE("doubles know how wrong they are", "[reference][exact]") {
    const Bounded sum = Bounded{1.0} + Bounded{0x1p-60};
    CHECK((sum.value == 1.0 && sum.error == 0x1p-60));
    const Bounded odd{0x1p27 + 1.0}; // its square is 2^54 + 2^28 + 1, which has 55 digits
    CHECK((odd * odd).value == 0x1p54 + 0x1p28);
    CHECK((odd * odd).error == 1.0);
    const Bounded exact = Bounded{0x1.fffffep0} * Bounded{0x1.000002p0};
    CHECK(exact.error == 0.0);
    CHECK(sure_sign(exact - exact) == 0);
    CHECK(sure_sign(sum - Bounded{1.0}) == std::nullopt);
    CHECK(sure_sign(Bounded{-1.0, 0.5}) == -1);
    const Between third = quotient({1.0, 0x1p-40}, {3.0, 0.0});
    CHECK((third.low < (1.0 - 0x1p-40) / 3.0 && third.high > (1.0 + 0x1p-40) / 3.0));
    CHECK(third.high - third.low < 0x1p-40);
}

TEST_CASE("doubles decide nothing otherwise than exact arithmetic", "[reference][exact]") {
    const int seed = 29;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    // Where much is exactly equal, exactly 0, or nearly so.
    const std::vector<Mesh> meshes{tripled(sphere(glm::vec3(0.0f), 1.0f, 1)),
                                   random_slivers(numbers, 20),
                                   split_on_one_side(as_loaded(latitude_sphere(1.0f, 4, 6))),
                                   walls_at_whole_coordinates(),
                                   flattened(random_triangles(numbers, 20), 2, 0.5f),
                                   mesh_of(triangles_at_powers_of_two())};
    std::size_t hits = 0;
    for (const Mesh& mesh : meshes) {
        const AnswerRules filtered(mesh.corners);
        const AnswerRules exact(mesh.corners, Arithmetic::exact);
        for (const RayFamily& family : ray_families(numbers, mesh.corners, 6)) {
            CAPTURE(family.name);
            for (const Ray& ray : family.rays) {
                const AllowedAnswer one = filtered.allowed(ray, anywhere);
                const AllowedAnswer other = exact.allowed(ray, anywhere);
                CHECK(one.miss == other.miss);
                CHECK(one.hits == other.hits);
                hits += one.hits.size();
            }
        }
    }
    CHECK(hits > 300);
}

TEST_CASE("the nearest hit of exact arithmetic is always among those allowed",
          "[reference][exact]") {
    const int seed = 23;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::vector<Mesh> meshes{sphere(glm::vec3(0.0f), 1.0f, 2), random_triangles(numbers, 40),
                             random_slivers(numbers, 40), copies_of_a_triangle(5)};
    meshes.push_back(flattened(random_triangles(numbers, 30), 1, 0.25f));
    for (const Mesh& mesh : meshes) {
        const AnswerRules rules(mesh.corners);
        for (const RayFamily& family : ray_families(numbers, mesh.corners, 20)) {
            CAPTURE(family.name);
            for (const Ray& ray : family.rays) {
                CHECK(allows(rules.allowed(ray, anywhere), exact_nearest_hit(ray, mesh.corners)));
            }
        }
    }
}
