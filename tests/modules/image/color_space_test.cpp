#include "image/color.h"

#include "catch.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace raysteps;

namespace {

// A linear number goes through two powers. An exponent rounded to float (half an epsilon) times the
// logarithm of the base (at most 5.8 for 0.0031308) makes 2.4 half-epsilons each; with one rounding
// for each of the 8 operations that is under 13 half-epsilons, and the slope 2.4 / 1.055 of the way
// back multiplies them: under 15 epsilons of a number that is at most 1.
constexpr float round_trip_error = 15.0f * std::numeric_limits<float>::epsilon();

float random_fraction() {
    return static_cast<float>(*rc::gen::inRange(0, 1 << 24)) / static_cast<float>(1 << 24);
}

} // namespace

TEST_CASE("sRGB keeps black and white", "[image]") {
    CHECK(srgb_from_linear(0.0f) == 0.0f);
    CHECK(linear_from_srgb(0.0f) == 0.0f);
    CHECK(std::abs(srgb_from_linear(1.0f) - 1.0f) <= round_trip_error);
    CHECK(std::abs(linear_from_srgb(1.0f) - 1.0f) <= round_trip_error);
}

TEST_CASE("sRGB is the curve of the standard", "[image]") {
    CHECK(std::abs(srgb_from_linear(0.0031308f) - 0.040449936f) <= round_trip_error);
    CHECK(std::abs(srgb_from_linear(0.5f) - 0.735356983f) <= round_trip_error);
    CHECK(std::abs(linear_from_srgb(0.5f) - 0.214041140f) <= round_trip_error);
    CHECK(std::abs(linear_from_srgb(0.04045f) - 0.003130805f) <= round_trip_error);
}

TEST_CASE("linear light is encoded as the nearest of 256 steps", "[image]") {
    CHECK(encode_srgb(0.0f) == 0);
    CHECK(encode_srgb(0.0031308f) == 10); // 0.04045 * 255 = 10.3
    CHECK(encode_srgb(0.5f) == 188);      // 0.73536 * 255 = 187.5
    CHECK(encode_srgb(1.0f) == 255);
}

TEST_CASE("light outside the range is encoded as the nearest end and NaN as 0", "[image]") {
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(encode_srgb(-1.0f) == 0);
    CHECK(encode_srgb(-infinity) == 0);
    CHECK(encode_srgb(2.0f) == 255);
    CHECK(encode_srgb(infinity) == 255);
    CHECK(encode_srgb(std::numeric_limits<float>::quiet_NaN()) == 0);
}

TEST_CASE("every one of the 256 steps comes back from its linear value", "[image]") {
    for (int step = 0; step < 256; step++) {
        CHECK(encode_srgb(decode_srgb(static_cast<std::uint8_t>(step))) == step);
    }
}

TEST_CASE("linear light comes back from sRGB", "[image]") {
    REQUIRE(rc::check([] {
        const float linear = random_fraction();
        RC_ASSERT(std::abs(linear_from_srgb(srgb_from_linear(linear)) - linear) <=
                  round_trip_error);
    }));
}

TEST_CASE("more light never has a lower step", "[image]") {
    REQUIRE(rc::check([] {
        const float a = random_fraction();
        const float b = random_fraction();
        RC_ASSERT(encode_srgb(std::min(a, b)) <= encode_srgb(std::max(a, b)));
    }));
}
