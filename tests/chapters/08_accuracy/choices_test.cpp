#include "08_accuracy/trade_offs.h"

#include "catch.h"
#include "gpu/context.h"
#include "hard_cases/aimed_rays.h"
#include "reference/exact.h"

#include <map>

using namespace raysteps;

namespace {

Effort little_effort() {
    Effort effort;
    effort.judged_rays = 2048;
    effort.timed_rays = 64;
    effort.picture_size = 32;
    effort.finest_grid = 512;
    effort.limits = measure_limits();
    return effort;
}

using Counts = std::map<std::string, std::map<std::string, Findings>>;

// What each method of each family gets wrong; nothing is timed.
Counts examine(const TradeOffTrials& trade_off) {
    Counts counts;
    for (const MethodTrial& trial : trade_off.trials) {
        trial.run();
        counts[trial.family][trial.method] = trial.examine();
    }
    return counts;
}

} // namespace

TEST_CASE("an exact box test knows its sides and corners and zeros", "[08][slab]") {
    const Box box{{0, 0, 0}, {1, 1, 1}};
    const auto meets = [&](const glm::vec3& origin, const glm::vec3& direction) {
        return exact_meets_box({origin, direction, 0.0f, no_end}, box);
    };
    CHECK(meets({0.5f, 0.5f, -1}, {0, 0, 1}));
    CHECK(meets({0, 0.5f, -1}, {0, 0, 1}));
    CHECK(meets({1, 0.5f, -1}, {-0.0f, 0, 1}));
    CHECK(meets({-1, -1, -1}, {1, 1, 1}));
    CHECK(meets({0, 0, -1}, {1, 0, 1}));                     // touches an edge
    CHECK_FALSE(meets({0, 0, -1}, {1.0f + 0x1p-23f, 0, 1})); // and passes it by an ulp
    CHECK_FALSE(meets({1.0f + 0x1p-23f, 0.5f, -1}, {0, 0, 1}));
    CHECK_FALSE(meets({0.5f, 0.5f, 2}, {0, 0, 1})); // behind
    CHECK(meets({0.5f, 0.5f, 0.5f}, {0, 0, 1}));
    CHECK(exact_meets_box({{-1, -1, 0}, {1, 1, 0}, 0.0f, no_end}, {{0, 0, 0}, {1, 1, 0}}));
}

TEST_CASE("room of four units makes the box test miss nothing at corners", "[08][slab]") {
    const auto context = make_context(ContextKind::automatic);
    Counts counts = examine(slab_trade_off(little_effort()));
    REQUIRE(counts.size() == 6);
    for (auto& [family, methods] : counts) {
        CAPTURE(family);
        CHECK(methods.at("padded").faults[0].count == 0);
    }
    CHECK(counts["inside"]["plain"].faults[0].count == 0);
    CHECK(counts["corner"]["plain"].faults[0].count > 0);
    CHECK(counts["corner of a flat box"]["plain"].faults[0].count > 0);
    CHECK(counts["along a side"]["plain"].faults[0].count == 0);
}

TEST_CASE("only the error bound leaves a surface in every unit", "[08][offset]") {
    const auto context = make_context(ContextKind::automatic);
    Counts counts = examine(offset_trade_off(little_effort()));
    REQUIRE(counts.size() == 4);
    for (auto& [family, methods] : counts) {
        CAPTURE(family);
        CHECK(total_fault(methods.at("error bound")).count == 0);
        CHECK(methods.at("none").faults[0].count > 0); // acne
    }
    CHECK(total_fault(counts["radius 1"]["waechter binder"]).count == 0);
    CHECK(counts["radius 0.001"]["waechter binder"].faults[1].count > 0); // leaks
    CHECK(counts["radius 0.001"]["fixed t"].faults[1].count > 0);
    CHECK(counts["radius 1000"]["fixed t"].faults[0].count > 0);
}

TEST_CASE("a trail on paper is the trail of the grid", "[08][grid]") {
    GridShape shape;
    shape.cells = {3, 3, 1};
    const GridTrail trail = grid_trail(shape, {{0.5f, 0.25f, 0.5f}, {1, 0.5f, 0}, 0.0f, no_end});
    // y = 0.25 + (x - 0.5) / 2 comes to 1 at x = 2, in the edge of four cells: x first.
    CHECK(trail.visits == 4); // 0, 1, 2, then 5 and out
    CHECK(trail.is_close);
    std::uint32_t mixed = 2166136261U;
    for (const std::uint32_t cell : {0U, 1U, 2U, 5U}) {
        mixed = (mixed ^ cell) * 16777619U;
    }
    CHECK(trail.mixed == mixed);
    CHECK_FALSE(grid_trail(shape, {{0.5f, 0.5f, 0.5f}, {1, 0, 0}, 0.0f, no_end}).is_close);
}

TEST_CASE("crossings from the index never stray and sums do the more the finer the grid",
          "[08][grid]") {
    const auto context = make_context(ContextKind::automatic);
    Counts counts = examine(grid_trade_off(little_effort()));
    for (auto& [family, methods] : counts) {
        CAPTURE(family);
        CHECK(total_fault(methods.at("from the index")).count == 0);
    }
    const std::size_t coarse = counts["256 cells across"]["added up"].faults[0].count;
    const std::size_t fine = counts["512 cells across"]["added up"].faults[0].count;
    CHECK(coarse > 0);
    CHECK(fine > 2 * coarse);
}

TEST_CASE("directions are right to a few ulp either way", "[08][primary]") {
    const auto context = make_context(ContextKind::automatic);
    const TradeOffTrials trade_off = primary_trade_off(little_effort());
    REQUIRE(trade_off.trials.size() == 6);
    for (const MethodTrial& trial : trade_off.trials) {
        CAPTURE(trial.family, trial.method);
        trial.run();
        const Findings findings = trial.examine();
        CHECK(findings.error->largest > 0.0);
        CHECK(findings.error->largest < 64.0); // chapter 01 tests the derived bounds
    }
}

TEST_CASE("more samples and mirrors and points come nearer to the truth", "[08][pictures]") {
    const auto context = make_context(ContextKind::automatic);
    Effort effort = little_effort();
    effort.most_samples = 2;
    for (const TradeOffTrials& trade_off :
         {samples_trade_off(effort), depth_trade_off(effort), lamp_trade_off(effort)}) {
        CAPTURE(trade_off.name);
        double last = 1e9;
        for (const MethodTrial& trial : trade_off.trials) {
            const Findings findings = trial.examine();
            REQUIRE(findings.measures[0].name == "RMSE");
            CHECK(findings.measures[0].value <= last);
            last = findings.measures[0].value;
        }
        CHECK(trade_off.pictures.size() >= 3);
    }
}
