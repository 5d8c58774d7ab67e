#include "07_compare/growth.h"
#include "catch.h"
#include "support/error_of.h"

using namespace raysteps;

namespace {

// Four logarithms and their sums round by less than 1e-14 here; the exponents are below 2.
constexpr double tolerance = 1e-12;

SceneCosts flake(int depth, int triangles, double rate) {
    RayCosts row{.contender = "grid", .kind = "primary", .rays = 1, .all_rays = 1};
    row.rate = {rate, rate, rate};
    return {"sphereflake:" + std::to_string(depth),
            triangles,
            {{"grid", {{"build_seconds", triangles * 1e-6}, {"memory_bytes", 0.0}}}},
            {row}};
}

} // namespace

TEST_CASE("points on a power of the number of triangles give its exponent", "[07][growth]") {
    for (const double exponent : {-0.5, 0.0, 0.333, 1.0, 1.7}) {
        std::vector<GrowthPoint> points;
        for (const double triangles : {1e3, 8e3, 3e4, 5e6}) {
            points.push_back({triangles, 7.0 * std::pow(triangles, exponent)});
        }
        CAPTURE(exponent);
        CHECK(std::abs(growth_exponent(points) - exponent) < tolerance);
    }
}

TEST_CASE("points off the line give the exponent of least squares", "[07][growth]") {
    // In powers of ten (0, 0), (1, 1), (2, 0), (3, 1): the slope is 1 / 5, worked out by hand.
    const std::vector<GrowthPoint> points{{1.0, 1.0}, {10.0, 10.0}, {100.0, 1.0}, {1000.0, 10.0}};
    CHECK(std::abs(growth_exponent(points) - 0.2) < tolerance);
}

TEST_CASE("an exponent of one size or of nothing is refused", "[07][growth][refusal]") {
    using Points = std::vector<GrowthPoint>;
    CHECK_THAT(error_of([] { growth_exponent(Points{}); }), contains_text("two scenes"));
    CHECK_THAT(error_of([] {
                   growth_exponent(Points{{5.0, 1.0}, {5.0, 2.0}});
               }),
               contains_text("two scenes"));
    CHECK_THAT(error_of([] {
                   growth_exponent(Points{{5.0, 1.0}, {6.0, 0.0}});
               }),
               contains_text("over 0"));
}

TEST_CASE("lines of growth are those of the series and of costs that were measured",
          "[07][growth]") {
    SceneCosts stranger = flake(0, 50, 100.0);
    stranger.scene = "knot:8";
    const std::vector<SceneCosts> results{flake(0, 1000, 4.0), stranger, flake(1, 10000, 2.0)};
    const std::vector<GrowthLine> lines = growth_lines(results, "sphereflake");
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].cost == "primary");
    REQUIRE(lines[0].points.size() == 2);
    CHECK(lines[0].points[0].cost == 250.0); // nanoseconds a ray at 4 million a second
    CHECK(std::abs(lines[0].exponent - std::log10(2.0)) < tolerance);
    CHECK(lines[1].cost == "build_seconds");
    CHECK(std::abs(lines[1].exponent - 1.0) < tolerance);
    CHECK(growth_lines(std::vector{results[0]}, "sphereflake").empty());
}
