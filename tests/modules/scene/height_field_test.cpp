#include "scene/samples/samples.h"

#include "catch.h"

#include <cmath>

using namespace raysteps;

TEST_CASE("a mountain begins as a plain and gets a summit", "[scene]") {
    REQUIRE(random_mountain(0, 1).heights == std::vector<float>(4, 0.0f));
    const HeightField field = random_mountain(1, 1);
    REQUIRE(field.cells == 2);
    REQUIRE(height_at(field, 1, 1) == 0.75f);
    REQUIRE(height_at(field, 0, 1) == 0.0f);
}

TEST_CASE("a finer mountain keeps the heights of the coarser one", "[scene]") {
    for (int depth = 1; depth < 7; ++depth) {
        CAPTURE(depth);
        const HeightField coarse = random_mountain(depth, 5);
        const HeightField fine = random_mountain(depth + 1, 5);
        REQUIRE(fine.cells == 2 * coarse.cells);
        for (int row = 0; row <= coarse.cells; ++row) {
            for (int column = 0; column <= coarse.cells; ++column) {
                REQUIRE(height_at(fine, 2 * column, 2 * row) == height_at(coarse, column, row));
            }
        }
    }
}

TEST_CASE("a new height is near the mean of its neighbours", "[scene]") {
    const int depth = 6;
    const HeightField coarse = random_mountain(depth - 1, 9);
    const HeightField fine = random_mountain(depth, 9);
    const float roughness = 0.3f / 16.0f; // halved by each level after the second
    for (int row = 1; row < fine.cells; row += 2) {
        for (int column = 1; column < fine.cells; column += 2) {
            const float mean = 0.25f * (height_at(coarse, column / 2, row / 2) +
                                        height_at(coarse, column / 2 + 1, row / 2) +
                                        height_at(coarse, column / 2, row / 2 + 1) +
                                        height_at(coarse, column / 2 + 1, row / 2 + 1));
            // One rounding of a sum of at most 2.
            REQUIRE(std::abs(height_at(fine, column, row) - mean) <= roughness + 0x1p-23f);
        }
    }
}

TEST_CASE("another seed gives another mountain", "[scene]") {
    REQUIRE(random_mountain(4, 1).heights != random_mountain(4, 2).heights);
}
