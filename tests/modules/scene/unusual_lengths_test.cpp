#include "catch.h"
#include "scene/ray_file.h"

using namespace raysteps;

namespace {

Ray along(const glm::vec3& direction) {
    return {{0.5f, 0.25f, 0.0f}, direction, 0.0f, 1.0f};
}

} // namespace

TEST_CASE("directions whose t is a normal float are nothing to speak of", "[scene][rays]") {
    const double reach = 4.0; // so from 2^-126 to 2^105
    CHECK(unusual_lengths({}, "rays.f32", reach).empty());
    const std::vector<Ray> usual{along({0, 0, 1}), along({-0.0f, 1e-30f, 1e-38f * 2.0f}),
                                 along({0, -0x1p105f, 1}), along({1e30f, 1e-30f, 0}),
                                 along({0, 0x1.8p-126f, 0})};
    CHECK(unusual_lengths(usual, "rays.f32", reach).empty());
}

TEST_CASE("directions too long or too short or with a denormal part are counted", "[scene][rays]") {
    const double reach = 4.0;
    const std::vector<Ray> rays{along({0, 0, 1}), along({0, 0, -0x1.1p105f}),
                                along({0, 0x1p-126f, 0}), along({1, 1e-40f, 0}), along({1, 1, 1})};
    for (const std::size_t only : {1, 2, 3}) {
        CHECK(!unusual_lengths(std::span(rays).subspan(only, 1), "rays.f32", reach).empty());
    }
    const std::string sentence = unusual_lengths(rays, "rays.f32", reach);
    CHECK_THAT(sentence, starts_with_text("rays.f32: 3 of 5 rays (the first is ray 1, from 0)"));
    CHECK_THAT(sentence, contains_text("1.2e-38 to 4.1e+31 for the longest component"));
}
