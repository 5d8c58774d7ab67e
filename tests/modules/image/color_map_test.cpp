#include "image/color.h"

#include "image/image.h"

#include "catch.h"

#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>

using namespace raysteps;

namespace {

glm::ivec3 steps_of(const glm::vec3& color) {
    return {encode_srgb(color.x), encode_srgb(color.y), encode_srgb(color.z)};
}

// Relative luminance, Rec. 709 primaries (IEC 61966-2-1:1999).
double luminance(const glm::vec3& color) {
    return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
}

} // namespace

TEST_CASE("the color map has viridis's known colors", "[image]") {
    CHECK(steps_of(color_map(0.0f)) == glm::ivec3(68, 1, 84));
    CHECK(steps_of(color_map(0.2f)) == glm::ivec3(65, 68, 135));
    CHECK(steps_of(color_map(1.0f)) == glm::ivec3(253, 231, 37));
    // Entry 128 of 256, which is none of the table's: within 1 step, as it is interpolated.
    const glm::ivec3 middle = steps_of(color_map(128.0f / 255.0f));
    CHECK(std::abs(middle.x - 33) <= 1);
    CHECK(std::abs(middle.y - 145) <= 1);
    CHECK(std::abs(middle.z - 140) <= 1);
}

TEST_CASE("values outside the color map get the nearer end and NaN gets magenta", "[image]") {
    const float infinity = std::numeric_limits<float>::infinity();
    CHECK(color_map(-0.5f) == color_map(0.0f));
    CHECK(color_map(-infinity) == color_map(0.0f));
    CHECK(color_map(1.5f) == color_map(1.0f));
    CHECK(color_map(infinity) == color_map(1.0f));
    CHECK(color_map(std::numeric_limits<float>::quiet_NaN()) == nan_color);
}

TEST_CASE("a greater value is a brighter color", "[image]") {
    // 1 / 4096 apart, the least rise of luminance (6e-6, in the dark end) is far over the rounding
    // of color_map, which is about 20 epsilons of numbers under 0.1 there.
    double last = -1.0;
    for (int i = 0; i <= 4096; i++) {
        CAPTURE(i);
        const double next = luminance(color_map(static_cast<float>(i) / 4096.0f));
        CHECK(next > last);
        last = next;
    }
}

TEST_CASE("every color of the map is in range and far from magenta", "[image]") {
    REQUIRE(rc::check([] {
        const glm::vec3 color =
            color_map(static_cast<float>(*rc::gen::inRange(0, 1 << 20)) / 1048576.0f);
        RC_ASSERT(std::min({color.x, color.y, color.z}) >= 0.0f);
        RC_ASSERT(std::max({color.x, color.y, color.z}) <= 1.0f);
        RC_ASSERT(glm::distance(color, nan_color) > 0.5f);
    }));
}
