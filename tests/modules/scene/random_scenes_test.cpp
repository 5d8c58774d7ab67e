#include "basics/random_numbers.h"

#include "catch.h"
#include "scene/samples/samples.h"

#include <glm/geometric.hpp>

#include <bit>
#include <cstdint>

using namespace raysteps;

namespace {

// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits) over the corners' bits, lowest byte first.
std::uint64_t checksum(const std::vector<glm::vec3>& corners) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const glm::vec3& corner : corners) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto bits = std::bit_cast<std::uint32_t>(corner[axis]);
            for (int shift = 0; shift < 32; shift += 8) {
                hash = (hash ^ (bits >> shift & 0xffu)) * 0x100000001b3u;
            }
        }
    }
    return hash;
}

} // namespace

TEST_CASE("random numbers come from the generator that the standard fixes", "[scene]") {
    // The first number of std::mt19937 with its usual seed 5489 is 3499211612.
    RandomNumbers random(5489);
    REQUIRE(random.unit() == static_cast<float>(3499211612u >> 8) / 16777216.0f);
}

TEST_CASE("random numbers lie in their ranges", "[scene]") {
    RandomNumbers random(3);
    for (int i = 0; i < 100'000; ++i) {
        const float unit = random.unit();
        const int below = random.below(7);
        REQUIRE((unit >= 0.0f && unit < 1.0f && below >= 0 && below < 7));
    }
}

TEST_CASE("the same seed gives the same bits on every machine", "[scene]") {
    // The soup was computed a second time by a program of another language.
    REQUIRE(checksum(sample_soup(1000, 7).corners) == 0x8a7e608fc07338adu);
    REQUIRE(checksum(sample_needles(1000, 7).corners) == 0x11752ab25327c2c1u);
}

TEST_CASE("another seed gives another soup", "[scene]") {
    REQUIRE(sample_soup(100, 1).corners != sample_soup(100, 2).corners);
    REQUIRE(sample_needles(100, 1).corners != sample_needles(100, 2).corners);
}

TEST_CASE("a soup lies in the cube from -1 to 1", "[scene]") {
    for (const int count : {1, 8, 1000}) {
        for (const glm::vec3& corner : sample_soup(count, 11).corners) {
            // The centre and the offset add up to 1 before rounding.
            REQUIRE(glm::max(glm::abs(corner), glm::vec3(1.0f)) == glm::vec3(1.0f));
        }
    }
}

TEST_CASE("needles are long and thin", "[scene]") {
    const std::vector<glm::vec3> corners = sample_needles(1000, 2).corners;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const float width = glm::distance(corners[i], corners[i + 1]);
        const float length = glm::distance(0.5f * (corners[i] + corners[i + 1]), corners[i + 2]);
        REQUIRE(length >= 0.499f);
        REQUIRE(length <= 1.001f);
        // Between 1 : 50 and 1 : 5000. Corners are rounded by 2^-25; the thinnest width is 1e-4.
        REQUIRE(width < 0.0201f * length);
        REQUIRE(width > 0.000199f * length);
    }
}
