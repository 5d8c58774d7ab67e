#include "07_compare/claims.h"
#include "catch.h"

using namespace raysteps;

namespace {

RayCosts row_of(const std::string& contender, const Rate& rate) {
    RayCosts row{.contender = contender, .kind = "primary", .rays = 1, .all_rays = 1};
    row.rate = rate;
    return row;
}

// Exact rates: no ranges.
SceneCosts scene_of(const std::string& name, double grid, double kd, double bvh) {
    return {name,
            1,
            {},
            {row_of("grid", {grid, grid, grid}), row_of("kd_ropes", {kd, kd, kd}),
             row_of("bvh_skip", {bvh, bvh, bvh})}};
}

// The verdicts on the three claims: grid slowest, kd before grid, BVH fastest.
std::vector<ClaimVerdict> verdicts_of(const std::vector<SceneCosts>& results) {
    std::vector<ClaimVerdict> verdicts;
    for (const ClaimResult& claim : judge_speed(results)) {
        verdicts.push_back(claim.verdict);
    }
    return verdicts;
}

using enum ClaimVerdict;
using Verdicts = std::vector<ClaimVerdict>;

} // namespace

TEST_CASE("the claims hold where the numbers are as the paper says", "[07][claims]") {
    CHECK(verdicts_of({scene_of("knot:8", 1.0, 2.0, 3.0)}) == Verdicts{holds, holds, holds});
}

TEST_CASE("the claims do not hold where the numbers contradict", "[07][claims]") {
    CHECK(verdicts_of({scene_of("knot:8", 3.0, 2.0, 1.0)}) ==
          Verdicts{does_not_hold, does_not_hold, does_not_hold});
}

TEST_CASE("for a single object the grid is to be faster than one of the others", "[07][claims]") {
    CHECK(verdicts_of({scene_of("compact:32", 2.0, 1.0, 3.0)}).front() == holds);
    CHECK(verdicts_of({scene_of("compact:32", 1.0, 2.0, 3.0)}).front() == does_not_hold);
    CHECK(verdicts_of({scene_of("compactor", 2.0, 1.0, 3.0)}).front() == does_not_hold);
}

TEST_CASE("where ranges overlap no winner is named", "[07][claims]") {
    SceneCosts close = scene_of("knot:8", 1.0, 2.0, 3.0);
    close.rays[0].rate = {1.0, 0.5, 4.0}; // the grid's best round is faster than all
    CHECK(verdicts_of({close}) == Verdicts{ranges_overlap, ranges_overlap, ranges_overlap});
    // Ranges that touch overlap.
    close.rays[0].rate = {1.0, 0.5, 2.0};
    const Verdicts touching = verdicts_of({close});
    CHECK(touching == Verdicts{ranges_overlap, ranges_overlap, holds});
}

TEST_CASE("one scene against is enough unless the claim is of most", "[07][claims]") {
    const SceneCosts usual = scene_of("knot:8", 1.0, 2.0, 3.0);
    const SceneCosts other = scene_of("soup:9", 3.0, 2.0, 1.0);
    CHECK(verdicts_of({usual, usual, other}) == Verdicts{does_not_hold, holds, does_not_hold});
    CHECK(verdicts_of({usual, other}) == Verdicts{does_not_hold, does_not_hold, does_not_hold});
}

TEST_CASE("a family is judged by its fastest walk", "[07][claims]") {
    SceneCosts result = scene_of("knot:8", 1.0, 2.0, 0.5);
    result.rays.push_back(row_of("bvh_ordered", {4.0, 3.0, 5.0}));
    CHECK(best_of_family(result, "primary", "bvh")->contender == "bvh_ordered");
    CHECK(verdicts_of({result}).back() == holds);
    CHECK_FALSE(best_of_family(result, "shadow", "bvh").has_value());
}

TEST_CASE("a family that took no part leaves the claims undecided", "[07][claims]") {
    SceneCosts result = scene_of("knot:8", 1.0, 2.0, 3.0);
    result.rays.pop_back();
    const std::vector<ClaimResult> claims = judge_speed(std::vector{result});
    REQUIRE(claims.size() == 3);
    for (const ClaimResult& claim : claims) {
        CHECK(claim.verdict == ranges_overlap);
        CHECK(claim.cases.empty());
    }
}

TEST_CASE("the simplest family is that of the shortest program", "[07][claims]") {
    const std::vector<ProgramLength> lengths{
        {"grid", 50}, {"kd_ropes", 90}, {"bvh_stack", 120}, {"bvh_skip", 40}};
    CHECK(judge_simplicity(lengths).verdict == holds);
    CHECK(judge_simplicity(std::span(lengths).first(3)).verdict == does_not_hold);
    CHECK(judge_simplicity(std::span(lengths).first(2)).verdict == ranges_overlap);
}
