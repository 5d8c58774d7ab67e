#include "build_trees.h"
#include "catch.h"
#include "hard_cases/aimed_rays.h"
#include "mirror/trace_by_mirror.h"
#include "support/error_of.h"

#include <algorithm>
#include <limits>
#include <span>

using namespace raysteps;

namespace {

// How many answers of the box test are not the true ones.
int count_wrong(std::span<const AimedBox> aimed, bool (*meets)(const Ray&, const Box&)) {
    return static_cast<int>(std::count_if(aimed.begin(), aimed.end(), [&](const AimedBox& one) {
        return meets(one.ray, one.box) != one.meets;
    }));
}

} // namespace

TEST_CASE("B1 a box is closed for rays in the planes of its sides", "[06][hard_case]") {
    const std::vector<AimedBox> aimed = rays_in_sides_of_a_box();
    CHECK(aimed.size() == 144);
    CHECK(count_wrong(aimed, meets_plain_box) == 0);
    CHECK(count_wrong(aimed, meets_padded_box) == 0);
}

TEST_CASE("B2 room of four units in the last place is enough for boxes that are not padded",
          "[06][hard_case]") {
    const int seed = 31;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    for (const auto make : {rays_at_corners_of_any_box, rays_that_touch_a_box}) {
        const std::vector<AimedBox> aimed = make(numbers, 100000);
        CHECK(count_wrong(aimed, meets_padded_box) == 0);
        CHECK(count_wrong(aimed, meets_plain_box) > 1000); // so the rays are worth their name
    }
}

TEST_CASE("B2 a box grown by nine roundings is not missed by the plain test", "[06][hard_case]") {
    const int seed = 32;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    std::vector<AimedBox> aimed = rays_at_corners_of_any_box(numbers, 100000);
    for (AimedBox& one : aimed) {
        one.box = grown_by_roundings(one.box);
    }
    CHECK(count_wrong(aimed, meets_plain_box) == 0);
}

TEST_CASE("B3 at an offset of a million the box test is as sharp as at zero", "[06][hard_case]") {
    // plane * inverse - origin * inverse would have an error of 0.06 here, at a side of 1.
    CHECK(count_wrong(rays_far_from_zero(), meets_plain_box) == 0);
}

TEST_CASE("B4 boxes behind and around the origin and at the very end of a ray", "[06][hard_case]") {
    CHECK(count_wrong(rays_that_end_at_a_box(), meets_plain_box) == 0);
}

TEST_CASE("B5 an empty box is never visited and one that is no number never built",
          "[06][hard_case]") {
    const int seed = 35;
    CAPTURE(seed);
    RandomNumbers numbers(seed);
    CHECK(count_wrong(rays_at_the_empty_box(numbers, 1000), meets_plain_box) == 0);
    const std::vector<glm::vec3> corners{
        {0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<float>::quiet_NaN(), 0}};
    CHECK_FALSE(error_of([&] { build_bvh(corners, {}); }).empty());
}
