#include "basics/random_numbers.h"
#include "catch.h"
#include "gpu/context.h"
#include "render/rays.h"

#include <algorithm>
#include <set>

using namespace raysteps;

namespace {

int column_of(std::size_t ray) {
    return static_cast<int>(texel_of_listed_ray(ray, 1024) % 1024);
}

int row_of(std::size_t ray) {
    return static_cast<int>(texel_of_listed_ray(ray, 1024) / 1024);
}

// The side of the smallest square of texels around some rays in a row.
int side_around(std::size_t first, std::size_t count) {
    int left = column_of(first);
    int right = left;
    int low = row_of(first);
    int high = low;
    for (std::size_t ray = first; ray < first + count; ++ray) {
        left = std::min(left, column_of(ray));
        right = std::max(right, column_of(ray));
        low = std::min(low, row_of(ray));
        high = std::max(high, row_of(ray));
    }
    return std::max(right - left, high - low) + 1;
}

} // namespace

TEST_CASE("the first rays of a list run along the curve of Morton", "[render]") {
    const std::pair<int, int> places[]{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {3, 0}};
    for (std::size_t ray = 0; ray < std::size(places); ++ray) {
        CHECK(column_of(ray) == places[ray].first);
        CHECK(row_of(ray) == places[ray].second);
    }
    CHECK(column_of(64) == 8); // the next block
    CHECK(row_of(64) == 0);
    CHECK(column_of(128 * 64) == 0); // the first of the next row of blocks
    CHECK(row_of(128 * 64) == 8);
}

TEST_CASE("neighbours in a list are neighbours in its textures", "[render]") {
    std::set<std::size_t> texels;
    for (std::size_t ray = 0; ray < 200 * 64; ray += 64) {
        CHECK(side_around(ray, 64) == 8);
        for (std::size_t four = 0; four < 64; four += 4) {
            CHECK(side_around(ray + four, 4) == 2);
        }
        for (std::size_t i = ray; i < ray + 64; ++i) {
            texels.insert(texel_of_listed_ray(i, 1024));
        }
    }
    CHECK(texels.size() == 200 * 64); // no two in one place
}

TEST_CASE("a list of rays comes back as it went up, and empty rays fill the rest",
          "[render][gpu]") {
    const int seed = 17;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    const auto context = make_context(ContextKind::automatic);
    for (const std::size_t count : {0U, 1U, 63U, 65U, 1000U, 8193U, 10007U}) {
        CAPTURE(count);
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < count; ++i) {
            rays.push_back({numbers.in_cube(), numbers.in_cube(), 0.25f, static_cast<float>(i)});
        }
        const RayTextures textures = upload_rays(rays);
        const std::vector<Ray> back = read_rays(textures, count);
        for (std::size_t i = 0; i < count; ++i) {
            REQUIRE(back[i].origin == rays[i].origin);
            REQUIRE(back[i].direction == rays[i].direction);
            REQUIRE(back[i].t_min == rays[i].t_min);
            REQUIRE(back[i].t_max == rays[i].t_max);
        }
        const std::vector<Ray> all = read_rays(textures);
        CHECK(all.size() < count + 128 * 64);
        CHECK(static_cast<std::size_t>(std::ranges::count_if(all, [](const Ray& ray) {
                  return ray.t_max >= ray.t_min;
              })) == count - std::min<std::size_t>(count, 1)); // the first one is empty itself
    }
}

TEST_CASE("a picture taken block by block has each of its pixels once", "[render]") {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {16, 8}, {51, 65}}) {
        std::vector<std::size_t> pixels = pixels_in_blocks(width, height);
        REQUIRE(pixels.size() == static_cast<std::size_t>(width) * height);
        std::ranges::sort(pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            REQUIRE(pixels[i] == i);
        }
    }
    // Whole blocks: as a list lies in textures of that width.
    const std::vector<std::size_t> pixels = pixels_in_blocks(16, 8);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        CHECK(pixels[i] == texel_of_listed_ray(i, 16));
    }
}
