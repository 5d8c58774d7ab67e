#include "measure/contest.h"

#include "catch.h"
#include "measure/measure_structures.h"
#include "support/error_of.h"

#include <chrono>
#include <thread>

using namespace raysteps;

TEST_CASE("contenders take turns and the first round is dropped", "[07][contest]") {
    std::string turns;
    std::vector<double> progress;
    const std::vector<Contender> contenders{{"a", [&] { turns += 'a'; }},
                                            {"b", [&] { turns += 'b'; }, [&] { turns += '('; }}};
    const std::vector<ContestTimes> times =
        run_contest(contenders, 2, [&](double part_done) { progress.push_back(part_done); });
    CHECK(turns == "a(ba(ba(b");
    REQUIRE(times.size() == 2);
    CHECK(times[0].name == "a");
    CHECK(times[1].name == "b");
    CHECK(times[0].rounds.size() == 2);
    CHECK(times[1].rounds.size() == 2);
    CHECK(progress.size() == 6);
    CHECK(progress.back() == 1.0);
}

TEST_CASE("a contender that sleeps takes time on the clock and none of a processor",
          "[07][contest]") {
    const std::vector<Contender> contenders{
        {"asleep", [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }}};
    const ContestTimes times = run_contest(contenders, 1).front();
    CHECK(clock_seconds(times).lowest >= 0.02);
    CHECK(cpu_seconds(times).median < clock_seconds(times).median);
}

TEST_CASE("what rounds come to is a median and a range of what was made of each", "[07][contest]") {
    const ContestTimes times{"a", {{2.0, 1.0}, {4.0, 8.0}, {8.0, 16.0}}};
    const MeasuredRange rate = over_rounds(times, [](const Seconds& s) { return 8.0 / s.clock; });
    CHECK(rate.median == 2.0);
    CHECK(rate.lowest == 1.0);
    CHECK(rate.highest == 4.0);
    CHECK(cpu_seconds(times).median == 8.0);
}

TEST_CASE("a contest without a round is refused", "[07][contest][refusal]") {
    CHECK_THAT(error_of([] { run_contest({}, 0); }), contains_text("--rounds 0"));
}

TEST_CASE("the ratio to Embree is that of our fastest walk", "[07][contest]") {
    const auto costs = [](const std::string& contender, double rate, double cores) {
        RayCosts row{.contender = contender, .kind = "primary", .rays = 1, .all_rays = 1};
        row.rate = {rate, rate, rate};
        row.cores = cores;
        return row;
    };
    SceneCosts scene{"knot:8", 1, {}, {costs("grid", 1.0, 2.0), costs("bvh_skip", 3.0, 2.0)}};
    CHECK(fastest_walk(scene, "primary")->contender == "bvh_skip");
    CHECK(fastest_walk(scene, "shadow") == nullptr);
    CHECK_FALSE(ratio_to_embree(scene, "primary").has_value());
    scene.rays.push_back(costs(embree_packets, 9.0, 1.0));
    scene.rays.push_back(costs(embree_single, 6.0, 1.0));
    CHECK(fastest_walk(scene, "primary")->contender == "bvh_skip");
    CHECK(ratio_to_embree(scene, "primary")->by_clock == 0.5);
    CHECK(ratio_to_embree(scene, "primary")->by_cpu == 0.25);
}
