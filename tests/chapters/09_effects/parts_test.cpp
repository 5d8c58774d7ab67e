#include "basics/random_numbers.h"
#include "catch.h"
#include "mirror/effects.h"
#include "mirror/mirror_scene.h"
#include "reference/optics.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <vector>

using namespace raysteps;

namespace {

using Single = mirror::EffectParts<float>;
using Double = mirror::EffectParts<double>;

double angle_of(double degrees) {
    return glm::radians(degrees);
}

} // namespace

TEST_CASE("at right angles glass reflects by the ratio of difference and sum of the indices",
          "[09][fresnel]") {
    Double parts{};
    Single single{};
    for (const auto& [n1, n2] : {std::pair{1.0, 1.5}, {1.5, 1.0}, {1.0, 2.4}, {1.33, 1.5}}) {
        const double ratio = (n1 - n2) / (n1 + n2);
        CHECK(parts.reflected_part(1.0, n1, n2) == Approx(ratio * ratio).epsilon(1e-14));
        // A dozen roundings, of which the difference of the indices magnifies one by up to
        // (n1 + n2) / (n1 - n2) = 17.
        CHECK(single.reflected_part(1.0f, static_cast<float>(n1), static_cast<float>(n2)) ==
              Approx(ratio * ratio).epsilon(4e-6));
    }
}

TEST_CASE("at a grazing angle everything is reflected", "[09][fresnel]") {
    Single single{};
    CHECK(single.reflected_part(0.0f, 1.0f, 1.5f) == 1.0f);
    CHECK(single.reflected_part(0.0f, 1.5f, 1.0f) == 1.0f);
    CHECK(single.reflected_part(1e-4f, 1.0f, 1.5f) > 0.999f);
}

TEST_CASE("Fresnel's part agrees with the formula by angles", "[09][fresnel]") {
    Single single{};
    Double parts{};
    for (const auto& [n1, n2] : {std::pair{1.0, 1.5}, {1.5, 1.0}, {1.0, 1.0}, {2.4, 1.33}}) {
        for (double degrees = 0.5; degrees < 90.0; degrees += 0.5) {
            CAPTURE(n1, n2, degrees);
            const double angle = angle_of(degrees);
            const double expected = fresnel_by_angle(angle, n1, n2);
            CHECK(std::abs(parts.reflected_part(std::cos(angle), n1, n2) - expected) < 1e-9);
            // In float the cosine behind is a square root of a difference: near the angle of total
            // reflection its error is the root of a rounding, 2^-12; the part changes at most four
            // times as fast.
            CHECK(std::abs(single.reflected_part(static_cast<float>(std::cos(angle)),
                                                 static_cast<float>(n1), static_cast<float>(n2)) -
                           expected) < 1e-3);
        }
    }
}

TEST_CASE("from glass to air reflection is total beyond 41 8103 degrees and not before",
          "[09][fresnel][hard_case]") {
    Single single{};
    const auto part = [&](double degrees) {
        return single.reflected_part(static_cast<float>(std::cos(angle_of(degrees))), 1.5f, 1.0f);
    };
    CHECK(part(41.8113) == 1.0f);
    CHECK(part(41.8093) < 1.0f);
    CHECK(part(41.8093) > 0.9f);
}

TEST_CASE("refraction keeps Snell's law and length and plane", "[09][fresnel]") {
    Double parts{};
    const int seed = 5;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(numbers.in_cube()) + 1e-3);
        glm::dvec3 direction = glm::normalize(glm::dvec3(numbers.in_cube()) + 1e-3);
        direction = glm::dot(direction, normal) > 0.0 ? -direction : direction;
        const double n1 = 1.0;
        const double n2 = 1.1 + static_cast<double>(numbers.unit());
        const glm::dvec3 refracted = parts.refracted_direction(direction, normal, n1, n2);
        CHECK(glm::length(refracted) == Approx(1.0).epsilon(1e-12));
        CHECK(n1 * glm::length(glm::cross(direction, normal)) ==
              Approx(n2 * glm::length(glm::cross(refracted, normal))).margin(1e-12));
        CHECK(std::abs(glm::dot(glm::cross(direction, normal), refracted)) < 1e-12);
        CHECK(glm::dot(refracted, normal) < 0.0);
    }
}

TEST_CASE("a ray remembers four bodies and forgets the outermost", "[09][media]") {
    Single parts{};
    glm::uvec4 media(0u);
    CHECK(parts.innermost_medium(media) == -1);
    for (int material = 0; material < 5; ++material) {
        media = parts.enter_medium(media, material);
        CHECK(parts.innermost_medium(media) == material);
    }
    CHECK(!parts.is_inside(media, 0));
    CHECK(parts.is_inside(media, 1));
    media = parts.leave_medium(media, 3); // from the middle: bodies may overlap
    CHECK(media == glm::uvec4(5u, 3u, 2u, 0u));
    CHECK(parts.leave_medium(media, 7) == media);
}

TEST_CASE("absorption multiplies with the length of the way", "[09][absorption]") {
    Double parts{};
    const glm::dvec3 kept(0.5, 1.0, 0.0);
    CHECK(parts.transmitted(kept, 0.0).x == 1.0);
    CHECK(parts.transmitted(kept, 3.0).x == Approx(0.125));
    CHECK(parts.transmitted(kept, 3.0).y == 1.0);
    CHECK(parts.transmitted(kept, 3.0).z == 0.0);
}

TEST_CASE("the first sample of a pixel is its middle and samples spread evenly", "[09][samples]") {
    Single parts{};
    CHECK(parts.point_in_pixel(0).x == 0.5f);
    CHECK(parts.point_in_pixel(0).y == 0.5f);
    // Of 256 points each of 16 squares should have 16. Roberts and Halton promise a discrepancy of
    // about log(n)^2 / n; 6 off is far under what random points do (about 4 is one deviation).
    for (int kind = 0; kind < 3; ++kind) {
        std::vector<int> counts(16, 0);
        for (int i = 0; i < 256; ++i) {
            const auto point = kind == 0   ? parts.point_in_pixel(i)
                               : kind == 1 ? parts.point_on_lamp(i, 3, 5)
                                           : parts.point_for_lens(i, 3, 5);
            REQUIRE(point.x >= 0.0f);
            REQUIRE(point.x < 1.0f);
            REQUIRE(point.y >= 0.0f);
            REQUIRE(point.y < 1.0f);
            ++counts[static_cast<std::size_t>(4 * static_cast<int>(4.0f * point.y) +
                                              static_cast<int>(4.0f * point.x))];
        }
        for (const int count : counts) {
            CAPTURE(kind, count);
            CHECK(std::abs(count - 16) <= 6);
        }
    }
}

TEST_CASE("a lens without width and a focus anywhere change no bit of a ray", "[09][lens]") {
    Single parts{};
    Single::View view{{0, 0, 0}, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}};
    const Single::Ray ray{{1, 2, 3}, {0.1f, -0.2f, -1.0f}, 0.0f, 9.0f};
    const auto moved =
        parts.lens_ray(ray, view, 0.0f, 3.0f, parts.point_of_disc(parts.point_for_lens(7, 1, 2)));
    CHECK(moved.origin == ray.origin);
    CHECK(moved.direction == ray.direction);
}

TEST_CASE("rays through all points of a lens meet in the sharp plane", "[09][lens]") {
    Double parts{};
    const Double::View view{{0, 0, 0}, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}};
    const Double::Ray ray{{0, 0, 0}, {0.3, -0.2, -1.0}, 0.0, 9.0};
    for (int i = 0; i < 64; ++i) {
        const auto on_disc = parts.point_of_disc(parts.point_for_lens(i, 0, 0));
        CHECK(on_disc.x * on_disc.x + on_disc.y * on_disc.y <= 1.0);
        const auto moved = parts.lens_ray(ray, view, 0.5, 4.0, on_disc);
        CHECK(glm::distance(moved.origin + 4.0 * moved.direction,
                            ray.origin + 4.0 * ray.direction) < 1e-12);
        CHECK(moved.origin.z == 0.0);
    }
}
