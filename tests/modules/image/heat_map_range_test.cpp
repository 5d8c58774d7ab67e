#include "image/heat_map.h"

#include "random_image.h"
#include "support/error_of.h"

#include "catch.h"

#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace raysteps;

namespace {

constexpr float largest = std::numeric_limits<float>::max();
constexpr float smallest = std::numeric_limits<float>::denorm_min();
constexpr HeatMapScale logarithmic = HeatMapScale::logarithmic;

std::vector<float> random_values() {
    std::vector<float> values;
    for (const std::uint32_t bits : *rc::gen::arbitrary<std::vector<std::uint32_t>>()) {
        values.push_back(std::bit_cast<float>(bits));
    }
    return values;
}

} // namespace

TEST_CASE("a range is found from the finite values", "[image]") {
    const std::vector<float> values{3.0f, not_a_number, -infinity, 0.0f, 12.0f, infinity};
    CHECK(auto_range(values).lower == 0.0f);
    CHECK(auto_range(values).upper == 12.0f);
    CHECK(auto_range(values, logarithmic).lower == 3.0f);
    CHECK(auto_range(values, logarithmic).upper == 12.0f);
}

TEST_CASE("equal values and no values still make a range", "[image]") {
    const auto ends = [](std::vector<float> values, HeatMapScale scale) {
        const HeatMapRange range = auto_range(values, scale);
        return std::vector<float>{range.lower, range.upper};
    };
    CHECK(ends({}, HeatMapScale::linear) == std::vector<float>{0.0f, 1.0f});
    CHECK(ends({not_a_number}, HeatMapScale::linear) == std::vector<float>{0.0f, 1.0f});
    CHECK(ends({0.0f}, HeatMapScale::linear) == std::vector<float>{0.0f, 1.0f});
    CHECK(ends({5.0f, 5.0f}, HeatMapScale::linear) == std::vector<float>{0.0f, 5.0f});
    CHECK(ends({-5.0f}, HeatMapScale::linear) == std::vector<float>{-5.0f, 0.0f});
    CHECK(ends({-5.0f}, logarithmic) == std::vector<float>{1.0f, 10.0f});
    CHECK(ends({5.0f}, logarithmic) == std::vector<float>{2.5f, 10.0f});
    CHECK(ends({largest}, logarithmic) == std::vector<float>{largest / 2.0f, largest});
    CHECK(ends({smallest}, logarithmic) == std::vector<float>{smallest, 2.0f * smallest});
}

TEST_CASE("a range that is found can always be used", "[image]") {
    REQUIRE(rc::check([] {
        const std::vector<float> values = random_values();
        for (const HeatMapScale scale : {HeatMapScale::linear, logarithmic}) {
            const HeatMapRange range = auto_range(values, scale);
            check_range(range);
            for (const float value : values) {
                const float fraction = fraction_of_range(value, range);
                RC_ASSERT(std::isnan(value) == std::isnan(fraction));
                RC_ASSERT(std::isnan(value) || (fraction >= 0.0f && fraction <= 1.0f));
            }
            const double middle = middle_of_range(range);
            RC_ASSERT(middle >= range.lower);
            RC_ASSERT(middle <= range.upper);
        }
    }));
}

TEST_CASE("the fraction of a value is known on both scales", "[image]") {
    const HeatMapRange linear{-2.0f, 2.0f};
    CHECK(fraction_of_range(-2.0f, linear) == 0.0f);
    CHECK(fraction_of_range(-1.0f, linear) == 0.25f);
    CHECK(fraction_of_range(2.0f, linear) == 1.0f);
    CHECK(fraction_of_range(infinity, linear) == 1.0f);
    CHECK(fraction_of_range(0.0f, {-largest, largest}) == 0.5f);
    const HeatMapRange decades{1.0f, 10000.0f, logarithmic};
    // Two logarithms and a quotient in double round to the float nearest 0.25.
    CHECK(fraction_of_range(10.0f, decades) == 0.25f);
    CHECK(fraction_of_range(0.0f, decades) == 0.0f);
    CHECK(fraction_of_range(-5.0f, decades) == 0.0f);
    CHECK(middle_of_range(linear) == 0.0);
    CHECK(middle_of_range(decades) == 100.0);
}

TEST_CASE("a range that is none is an error", "[image]") {
    const std::vector<HeatMapRange> ranges{{1.0f, 1.0f},
                                           {2.0f, 1.0f},
                                           {0.0f, infinity},
                                           {not_a_number, 1.0f},
                                           {0.0f, not_a_number},
                                           {0.0f, 1.0f, logarithmic},
                                           {-1.0f, 1.0f, logarithmic}};
    for (const HeatMapRange& range : ranges) {
        CAPTURE(range.lower);
        CAPTURE(range.upper);
        CHECK(error_of([&] { check_range(range); }).find("cannot go from") != std::string::npos);
    }
}
