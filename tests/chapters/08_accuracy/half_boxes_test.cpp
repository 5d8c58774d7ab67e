#include "structure/bvh/bvh.h"

#include "basics/random_numbers.h"
#include "catch.h"
#include "hard_cases/meshes.h"
#include "structure/structure.h"

#include <cmath>

using namespace raysteps;

TEST_CASE("a half is the nearest one outside", "[08][half]") {
    const int seed = 2;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int i = 0; i < 2000; ++i) {
        HalfFrame frame{100.0f * numbers.in_cube(), glm::vec3(0.001f + 10.0f * numbers.unit())};
        const float value = frame.lower.x + frame.size.x * numbers.unit();
        const int below = half_below(frame, 0, value);
        const int above = half_above(frame, 0, value);
        REQUIRE(half_plane(frame, 0, below) <= value);
        REQUIRE(half_plane(frame, 0, above) >= value);
        // Halves from 1/2 to 1 are 2^-11 apart, smaller ones less; where 2^-14 is the first after
        // 0, they are that far. Sum and product are rounded by an ulp of the coordinates, below
        // 2^-16.
        const float step = frame.size.x * 0x1p-11f + 0x1p-15f;
        REQUIRE(half_plane(frame, 0, above) - half_plane(frame, 0, below) <= step);
    }
    const HalfFrame unit{glm::vec3(0.0f), glm::vec3(1.0f)};
    CHECK(half_below(unit, 0, 0.0f) == 0);
    CHECK(half_above(unit, 0, 0.0f) == 0);
    CHECK(half_below(unit, 1, 1.0f) == 0x3c00);
    CHECK(half_above(unit, 1, 1.0f) == 0x3c00);
    CHECK(half_below(unit, 2, 0.5f) == 0x3800);
    CHECK(half_below(unit, 2, 0x1p-15f) == 0); // no denormals
    CHECK(half_above(unit, 2, 0x1p-15f) == 0x0400);
}

TEST_CASE("half boxes hold the boxes that they stand for", "[08][half]") {
    const int seed = 4;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const Mesh mesh = random_triangles(numbers, 300);
    const BuiltStructure whole = family_of("bvh").build(mesh.corners, {4.0f, {}});
    const BuiltStructure half = family_of("half_bvh").build(mesh.corners, {4.0f, {}});
    const int count = whole.packed.numbers.at("bvh_node_count");
    REQUIRE(half.packed.numbers.at("bvh_node_count") == count);
    const auto& nodes = whole.packed.integer_vectors.at("bvh_nodes");
    const auto& halves = half.packed.integer_vectors.at("half_nodes");
    REQUIRE(halves.size() == static_cast<std::size_t>(count));
    const HalfFrame frame{half.packed.points.at("half_lower"), half.packed.points.at("half_size")};
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const glm::ivec4 bits = halves[i];
        REQUIRE(half_plane(frame, 0, bits.x & 0xffff) <= std::bit_cast<float>(nodes[2 * i].x));
        REQUIRE(half_plane(frame, 1, bits.x >> 16) <= std::bit_cast<float>(nodes[2 * i].y));
        REQUIRE(half_plane(frame, 2, bits.y & 0xffff) <= std::bit_cast<float>(nodes[2 * i].z));
        REQUIRE(half_plane(frame, 0, bits.y >> 16) >= std::bit_cast<float>(nodes[2 * i + 1].x));
        REQUIRE(half_plane(frame, 1, bits.z & 0xffff) >= std::bit_cast<float>(nodes[2 * i + 1].y));
        REQUIRE(half_plane(frame, 2, bits.z >> 16) >= std::bit_cast<float>(nodes[2 * i + 1].z));
    }
}
