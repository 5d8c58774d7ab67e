#include "basics/random_numbers.h"
#include "catch.h"
#include "mirror/walks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace raysteps;

// With whole numbers of 24 binary digits as coordinates, the true area is a whole number of 50
// digits at most: integers tell it exactly.

namespace {

using Mirror = mirror::walks::every_triangle<float>;

struct Place {
    std::int64_t x;
    std::int64_t y;
};

constexpr std::int64_t greatest = (1 << 24) - 1;

float area_of(const Place& a, const Place& b, float scale) {
    Mirror mirror{};
    const glm::vec3 p(scale * static_cast<float>(a.x), scale * static_cast<float>(a.y), 0.0f);
    const glm::vec3 q(scale * static_cast<float>(b.x), scale * static_cast<float>(b.y), 0.0f);
    return mirror.exact_area(p, q, mirror.halves(p.x), mirror.halves(p.y), mirror.halves(q.x),
                             mirror.halves(q.y));
}

std::int64_t true_area(const Place& a, const Place& b) {
    return a.x * b.y - a.y * b.x;
}

std::int64_t whole(double value) {
    return std::clamp(static_cast<std::int64_t>(std::llround(value)), -greatest, greatest);
}

// Two places that are nearly on one line with the origin: what is left of the products is small.
std::pair<Place, Place> nearly_in_line(RandomNumbers& numbers) {
    const double factor = 2.0 * numbers.unit() - 1.0;
    const Place a{whole(greatest * (2.0 * numbers.unit() - 1.0)),
                  whole(greatest * (2.0 * numbers.unit() - 1.0))};
    const auto off = [&] { return static_cast<double>(numbers.below(3) - 1); };
    return {a,
            {whole(factor * static_cast<double>(a.x) + off()),
             whole(factor * static_cast<double>(a.y) + off())}};
}

} // namespace

TEST_CASE("the exact area of a unit triangle is one", "[02][exact_area]") {
    CHECK(area_of({1, 0}, {0, 1}, 1.0f) == 1.0f);
    CHECK(area_of({0, 1}, {1, 0}, 1.0f) == -1.0f);
    CHECK(area_of({3, 4}, {6, 8}, 1.0f) == 0.0f);
    // (2^24 - 1)^2 - (2^24 - 2) 2^24 = 1: both products round to the same number.
    CHECK(area_of({greatest, greatest - 1}, {greatest + 1, greatest}, 1.0f) == 1.0f);
}

TEST_CASE("the exact area has the sign of the true one and almost its value", "[02][exact_area]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    int in_line = 0;
    for (int i = 0; i < 300000; ++i) {
        const auto [a, b] = nearly_in_line(numbers);
        const std::int64_t exact = true_area(a, b);
        in_line += exact == 0 ? 1 : 0;
        for (const float scale : {1.0f, 0x1p-24f, 0x1p-36f}) {
            const double area = area_of(a, b, scale);
            const double expected = static_cast<double>(exact) * scale * scale;
            CAPTURE(a.x, a.y, b.x, b.y, scale);
            // 4 roundings of 2^-24 each (triangle/watertight/exact_area.glsl).
            REQUIRE(std::abs(area - expected) <= 4 * 0x1p-24 * std::abs(expected));
        }
    }
    CHECK(in_line < 300000);
}

TEST_CASE("an exact area too small for its missing parts keeps its sign or is zero",
          "[02][exact_area]") {
    const int seed = 12;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int i = 0; i < 100000; ++i) {
        const auto [a, b] = nearly_in_line(numbers);
        for (const float scale : {0x1p-62f, 0x1p-70f, 0x1p-100f}) {
            const float area = area_of(a, b, scale);
            const std::int64_t exact = true_area(a, b);
            CAPTURE(a.x, a.y, b.x, b.y, scale);
            REQUIRE((area == 0.0f || (area > 0.0f) == (exact > 0)));
        }
    }
}
