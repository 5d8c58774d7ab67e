#include "10_speed/climb.h"

#include "basics/error.h"
#include "basics/random_numbers.h"
#include "catch.h"
#include "gpu/context.h"
#include "scene/load_scene.h"
#include "support/expected_picture.h"

#include <algorithm>
#include <numeric>

using namespace raysteps;

namespace {

CountedVisits same_everywhere(int width, int height, std::uint32_t visits) {
    return {width, height,
            std::vector<std::uint32_t>(static_cast<std::size_t>(width * height), visits)};
}

CountedVisits random_visits(RandomNumbers& numbers, int width, int height) {
    CountedVisits counted = same_everywhere(width, height, 0);
    for (std::uint32_t& visits : counted.visits) {
        visits = static_cast<std::uint32_t>(numbers.below(50));
    }
    return counted;
}

} // namespace

TEST_CASE("a block makes as many rounds as its slowest ray has visits", "[10][lanes]") {
    // Two blocks of 4 x 2, the bottom row first.
    const CountedVisits counted{8, 2, {1, 2, 3, 4, 9, 0, 0, 0, 5, 6, 7, 2, 0, 0, 0, 0}};
    CHECK(rounds_of_blocks(counted) ==
          std::vector<std::uint32_t>{7, 7, 7, 7, 9, 9, 9, 9, 7, 7, 7, 7, 9, 9, 9, 9});
}

TEST_CASE("lanes at work are visits over rounds times eight", "[10][lanes]") {
    CHECK(lanes_at_work(same_everywhere(8, 4, 3)) == 1.0);
    // One ray of eight has anything to do.
    CHECK(lanes_at_work({4, 2, {0, 0, 0, 0, 0, 12, 0, 0}}) == 0.125);
    // 30 visits in 7 rounds of 8, and 9 in 9 rounds of 8.
    CHECK(lanes_at_work({8, 2, {1, 2, 3, 4, 9, 0, 0, 0, 5, 6, 7, 2, 0, 0, 0, 0}}) ==
          39.0 / (8 * 7 + 8 * 9));
}

TEST_CASE("lanes beyond the edge of a picture wait", "[10][lanes]") {
    CHECK(lanes_at_work(same_everywhere(1, 1, 5)) == 0.125);
    CHECK(lanes_at_work(same_everywhere(5, 2, 4)) == 10.0 / 16.0);
    CHECK(lanes_at_work(same_everywhere(4, 3, 4)) == 12.0 / 16.0);
}

TEST_CASE("where nothing is visited nobody waits", "[10][lanes]") {
    CHECK(lanes_at_work(same_everywhere(8, 2, 0)) == 1.0);
    CHECK(lanes_at_work(same_everywhere(0, 0, 0)) == 1.0);
}

TEST_CASE("lanes at work do not depend on who is where in a block, nor on the unit",
          "[10][lanes]") {
    const int seed = 11;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (int trial = 0; trial < 50; ++trial) {
        const CountedVisits counted =
            random_visits(numbers, 4 * (1 + trial % 5), 2 * (1 + trial % 7));
        CountedVisits turned = counted; // each block by itself
        for (std::size_t row = 0; row + 1 < static_cast<std::size_t>(counted.height); row += 2) {
            const auto width = static_cast<std::size_t>(counted.width);
            for (std::size_t column = 0; column < width; ++column) {
                std::swap(turned.visits[row * width + column],
                          turned.visits[(row + 1) * width + column]);
            }
        }
        CountedVisits twice = counted;
        for (std::uint32_t& visits : twice.visits) {
            visits *= 2;
        }
        CHECK(lanes_at_work(turned) == lanes_at_work(counted));
        CHECK(lanes_at_work(twice) == lanes_at_work(counted));
        CHECK(lanes_at_work(counted) <= 1.0);
        // A list that is sorted has neighbours that are more alike.
        CountedVisits one_row = counted;
        one_row.width = 4;
        one_row.height = static_cast<int>(counted.visits.size()) / 4;
        CountedVisits sorted = one_row;
        std::ranges::sort(sorted.visits);
        CHECK(lanes_at_work(sorted) >= lanes_at_work(one_row));
    }
}

TEST_CASE("blocks of walks are drawn in the same colours, and have to be of one size",
          "[10][lanes]") {
    const CountedVisits few = same_everywhere(64, 32, 2);
    const CountedVisits many = same_everywhere(64, 32, 200);
    const Image picture = draw_blocks({{"few", few}, {"many", many}});
    const Image other_way = draw_blocks({{"many", many}, {"few", few}});
    CHECK(picture.width >= 128);
    CHECK(picture.at(picture.width / 4, 5) == other_way.at(3 * picture.width / 4, 5));
    CHECK(picture.at(picture.width / 4, 5) != picture.at(3 * picture.width / 4, 5));
    CHECK_THROWS_AS(draw_blocks({{"few", few}, {"small", same_everywhere(8, 8, 1)}}), InputError);
}

TEST_CASE("the blocks of the bunny are those of the expected picture", "[10][picture]") {
    const auto context = make_context(ContextKind::automatic);
    const Scene scene = load_scene("bunny", 1.0f);
    VisitCounter counter(scene, {"bvh_skip", "bvh4"}, measure_limits());
    const Image picture = draw_blocks(counter.count(scene.camera, 256, 256));
    CHECK(unexpected_pixels(picture, "10_speed") == 0);
}
