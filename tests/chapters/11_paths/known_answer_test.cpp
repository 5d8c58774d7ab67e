#include "catch.h"
#include "path_pictures.h"

#include <array>
#include <numbers>

using namespace raysteps;

namespace {

// A box around the eye whose walls all glow alike and keep the same part of the light: a white
// furnace.
Scene furnace(float kept, float glow) {
    Scene scene = add_mesh(Scene{}, box({-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}),
                           glowing_material(glm::vec3(kept), glm::vec3(glow)));
    for (std::size_t i = 0; i < scene.corners.size(); i += 3) { // the fronts inwards
        std::swap(scene.corners[i + 1], scene.corners[i + 2]);
        std::swap(scene.normals[i + 1], scene.normals[i + 2]);
    }
    scene.camera = {{0.1f, 0.2f, 0.3f}, {0.9f, -0.1f, 0.0f}, {0.0f, 1.0f, 0.0f}, 90.0f};
    return scene;
}

// The part of the light of a parallel rectangle that a point sees, weighed by its cosine: the
// corner of the rectangle is over the point, its sides are a and b times as long as its height.
// Source: Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-4.
double factor_of_corner(double a, double b) {
    const double root_a = std::sqrt(1.0 + a * a);
    const double root_b = std::sqrt(1.0 + b * b);
    return (a / root_a * std::atan(b / root_a) + b / root_b * std::atan(a / root_b)) /
           (2.0 * std::numbers::pi);
}

constexpr float lamp_height = 1.0f;
constexpr float half_lamp = 0.5f;
constexpr float plane_color = 0.5f;
constexpr float lamp_glow = 3.0f;

// A square lamp over a plane, seen from beside: nothing else reflects.
Scene lamp_over_plane(float half_side) {
    Scene scene = add_mesh(
        Scene{},
        quad({-9.0f, 0.0f, 9.0f}, {9.0f, 0.0f, 9.0f}, {9.0f, 0.0f, -9.0f}, {-9.0f, 0.0f, -9.0f}),
        glowing_material(glm::vec3(plane_color), glm::vec3(0.0f)));
    const float s = half_side;
    scene = add_mesh(std::move(scene),
                     quad({-s, lamp_height, -s}, {s, lamp_height, -s}, {s, lamp_height, s},
                          {-s, lamp_height, s}),
                     glowing_material(glm::vec3(0.0f), glm::vec3(lamp_glow)));
    // Looks at the origin through a view so narrow that all of it is the same point.
    scene.camera = {{0.0f, 0.5f, 2.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 0.01f};
    return scene;
}

double radiance_under(double half_side) {
    return 4.0 * factor_of_corner(half_side / lamp_height, half_side / lamp_height) *
           static_cast<double>(plane_color * lamp_glow);
}

} // namespace

TEST_CASE("in a white furnace each sample is the exact sum, bounce by bounce", "[11][furnace]") {
    const auto context = make_context(ContextKind::automatic);
    // With halves every term and every sum is a float, so nothing at all is rounded.
    for (const int bounces : {0, 1, 2, 5, 16}) {
        PathChoice choice{.heuristic = "bounce_only", .roulette = "none", .max_bounces = bounces};
        const Image image = mean_of(follow_paths(furnace(0.5f, 1.0f), choice, 8, 1));
        const float expected = 2.0f - std::ldexp(1.0f, -bounces);
        int wrong = 0;
        for (const glm::vec3& pixel : image.pixels) {
            wrong += pixel == glm::vec3(expected) ? 0 : 1;
        }
        CAPTURE(bounces, expected);
        CHECK(wrong == 0);
    }
}

TEST_CASE("in a white furnace of any colour a sample is off by its roundings alone",
          "[11][furnace]") {
    const auto context = make_context(ContextKind::automatic);
    constexpr int bounces = 40;
    constexpr float kept = 0.7f;
    const PathChoice choice{.heuristic = "bounce_only", .roulette = "none", .max_bounces = bounces};
    const Image image = mean_of(follow_paths(furnace(kept, 0.3f), choice, 8, 1));
    double sum = 0.0;
    double term = static_cast<double>(0.3f);
    for (int i = 0; i <= bounces; ++i) {
        sum += term;
        term *= static_cast<double>(kept);
    }
    // All terms are positive. The weight of term i has i roundings, the term one more, and it then
    // takes part in at most 41 sums of a sample, 16 of a block and a division: (40 + 1 + 41 + 17)
    // e, for the largest of them, of each part of the sum.
    const double bound = 99.0 * 0x1p-24 * sum;
    double worst = 0.0;
    for (const glm::vec3& pixel : image.pixels) {
        worst = std::max(worst, std::abs(static_cast<double>(pixel.x) - sum));
    }
    CAPTURE(worst, bound);
    CHECK(worst <= bound);
}

TEST_CASE("roulette, both ways to a lamp and either bounce leave a furnace as it is",
          "[11][furnace]") {
    const auto context = make_context(ContextKind::automatic);
    for (const std::string heuristic : {"balance", "power", "light_only", "bounce_only"}) {
        for (const std::string bounce : {"cosine", "uniform"}) {
            const PathChoice choice{.random = "pcg",
                                    .bounce = bounce,
                                    .heuristic = heuristic,
                                    .roulette = "by_weight",
                                    .max_bounces = 1000};
            PathSums sums = follow_paths(furnace(0.5f, 1.0f), choice, 16, 16);
            std::ranges::fill(sums.sees_lamp, 0); // all of it is a lamp
            const MeasuredMean measured = measured_mean(sums);
            CAPTURE(heuristic, bounce, measured.mean, measured.error);
            CHECK(std::abs(measured.mean - 2.0) < alarm_at * measured.error + 1e-5);
            CHECK(measured.error < 0.02);
        }
    }
}

TEST_CASE("a lamp over a plane lights it as the formula says, by every way of finding it",
          "[11][lamp]") {
    const auto context = make_context(ContextKind::automatic);
    const double expected = radiance_under(half_lamp);
    for (const std::string heuristic : {"balance", "power", "light_only", "bounce_only"}) {
        for (const std::string bounce : {"cosine", "uniform"}) {
            const PathChoice choice{
                .random = "pcg", .bounce = bounce, .heuristic = heuristic, .max_bounces = 1};
            const MeasuredMean measured =
                measured_mean(follow_paths(lamp_over_plane(half_lamp), choice, 32, 16));
            CAPTURE(heuristic, bounce, expected, measured.mean, measured.error);
            // 1e-5 for the roundings of float and for a view that is not quite a point.
            CHECK(std::abs(measured.mean - expected) < alarm_at * measured.error + 1e-5 * expected);
            CHECK(measured.error < 0.006 * expected);
        }
    }
}

TEST_CASE(
    "a bias of 1 % under a lamp is found in 99.9 % of runs, and none is found where there is none",
    "[11][lamp]") {
    const auto context = make_context(ContextKind::automatic);
    const MeasuredMean expected{radiance_under(half_lamp), 0.0};
    for (const std::string heuristic : {"balance", "power", "light_only"}) {
        const PathChoice choice{
            .random = "pcg", .heuristic = heuristic, .max_bounces = 1, .seed = 9};
        const MeasuredMean measured =
            measured_mean(follow_paths(lamp_over_plane(half_lamp), choice, 32, 24));
        CAPTURE(heuristic, expected.mean, measured.mean, measured.error);
        CHECK(smallest_bias_found(measured, expected) < 0.01);
        CHECK(apart(measured, expected) < alarm_at);
        CHECK(apart({1.01 * measured.mean, measured.error}, expected) > alarm_at);
        CHECK(apart({0.99 * measured.mean, measured.error}, expected) > alarm_at);
    }
}

TEST_CASE("the independent recursion gives the same lamp and the same furnace", "[11][reference]") {
    const std::vector<std::uint8_t> all(1, 0);
    const double expected = radiance_under(half_lamp);
    const MeasuredMean lamp = measured_mean(
        follow_reference_paths(lamp_over_plane(half_lamp), {.samples = 40000, .max_bounces = 1}),
        all);
    CHECK(std::abs(lamp.mean - expected) < alarm_at * lamp.error);
    CHECK(lamp.error < 0.002 * expected);
    const MeasuredMean warm = measured_mean(
        follow_reference_paths(furnace(0.5f, 1.0f), {.samples = 20000, .max_bounces = 20}), all);
    CHECK(std::abs(warm.mean - 2.0) < alarm_at * warm.error + 2e-6);
    CHECK(warm.error < 0.04);
}

TEST_CASE("a lamp behind a mirror or in clear glass is seen as such", "[11][glass]") {
    const auto context = make_context(ContextKind::automatic);
    // A wall that glows, seen through a slab of glass of index 1: nothing is bent or lost.
    Scene scene = add_mesh(Scene{}, quad({-5, -5, -3}, {5, -5, -3}, {5, 5, -3}, {-5, 5, -3}),
                           glowing_material(glm::vec3(0.0f), glm::vec3(0.5f)));
    Material clear = glowing_material(glm::vec3(0.0f), glm::vec3(0.0f));
    clear.illumination_model = 7;
    scene = add_mesh(std::move(scene), box({-4, -4, -1}, {4, 4, 0}), clear);
    scene.camera = {{0.0f, 0.0f, 4.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 20.0f};
    const Image through = mean_of(follow_paths(scene, {}, 8, 1));
    for (const glm::vec3& pixel : through.pixels) {
        CHECK(pixel == glm::vec3(0.5f));
    }
    // With an index and absorption: by Fresnel and Beer at right angles, within a narrow view.
    scene.materials.back().refractive_index = 1.5f;
    scene.materials.back().transmission = glm::vec3(0.25f);
    scene.camera.vertical_field_of_view = 0.1f;
    const double off = 0.04; // ((1.5 - 1) / (1.5 + 1))^2
    // Light that goes to and fro in the slab comes out later, each time less.
    const double expected =
        0.5 * (1.0 - off) * (1.0 - off) * 0.25 / (1.0 - off * off * 0.25 * 0.25);
    const MeasuredMean measured = measured_mean([&] {
        PathSums sums = follow_paths(scene, {.random = "pcg"}, 32, 16);
        std::ranges::fill(sums.sees_lamp, 0);
        return sums;
    }());
    CAPTURE(measured.mean, expected, measured.error);
    CHECK(std::abs(measured.mean - expected) < alarm_at * measured.error + 1e-5);
    CHECK(measured.error < 0.01 * expected);
}
