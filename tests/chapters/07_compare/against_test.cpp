#include "07_compare/against.h"

#include "catch.h"
#include "support/error_of.h"

#include <fmt/core.h>

using namespace raysteps;

namespace {

std::string walk_json(const std::string& name, double rate, int rays) {
    return fmt::format(R"({{"contender": "{0}", "rays": {2}, "million_rays_per_second": {1},
        "lowest": {1}, "highest": {1}, "million_rays_per_cpu_second": {3}, "lowest_by_cpu_time":
        {3}, "highest_by_cpu_time": {3}, "to_embree": {{"median": {4}, "lowest": {4},
        "highest": {4}}}}})",
                       name, rate, rays, rate / 2.0, rate / 8.0);
}

// A run with one scene and one kind of rays.
Numbers run_with(const std::string& walks, const std::string& embree = "",
                 const std::string& cpu = "abacus", const std::string& renderer = "llvmpipe") {
    return parse_json(fmt::format(
                          R"({{"head": {{"commit": "c", "date": "d", "cpu": "{}", "cores": 2,
            "renderer": "{}", "opengl": "4.5", "builders": {{}}, "scenes": []}}, "rounds": 5,
            "embree": "{}", "embree_mode": "robust", "scenes": [{{"scene": "knot:8",
            "kinds": [{{"kind": "primary", "walks": [{}]}}]}}]}})",
                          cpu, renderer, embree, walks),
                      "run.json");
}

} // namespace

TEST_CASE("each walk that both runs have is compared by the yardstick", "[07][against]") {
    const Numbers then = run_with(walk_json("grid", 2.0, 64) + "," + walk_json("gone", 1.0, 64));
    const Numbers now = run_with(walk_json("new", 1.0, 64) + "," + walk_json("grid", 4.0, 128));
    const auto changed = changed_rates(then, now, Yardstick::clock);
    REQUIRE(changed.size() == 1);
    CHECK(changed[0].scene == "knot:8");
    CHECK(changed[0].kind == "primary");
    CHECK(changed[0].contender == "grid");
    CHECK(changed[0].then.median == 2.0);
    CHECK(changed[0].now.median == 4.0);
    CHECK_FALSE(changed[0].same_rays);
    CHECK(changed_rates(then, now, Yardstick::processor_time)[0].now.median == 2.0);
    CHECK(changed_rates(then, now, Yardstick::embree)[0].now.median == 0.5);
}

TEST_CASE("the yardstick is Embree in both runs or else the time of the same machine",
          "[07][against]") {
    const auto yardstick = [](const Numbers& then, const Numbers& now) {
        return choose_yardstick({"then.json", then}, now);
    };
    const std::string embree = "Embree 3.13.5";
    CHECK(yardstick(run_with("", embree), run_with("", embree, "other")) == Yardstick::embree);
    CHECK(yardstick(run_with(""), run_with("", embree)) == Yardstick::processor_time);
    CHECK(yardstick(run_with("", "Embree 4"), run_with("", embree)) == Yardstick::processor_time);
    CHECK(yardstick(run_with("", "", "abacus", "a GPU"), run_with("", "", "abacus", "a GPU")) ==
          Yardstick::clock);
    CHECK_THAT(error_of([&] { yardstick(run_with("", "", "other"), run_with("")); }),
               contains_text("then.json: it was measured on another machine (other, 2 cores, "
                             "llvmpipe, 4.5 there, abacus, 2 cores, llvmpipe, 4.5 here)"));
}

TEST_CASE("chance puts all rounds of one run below another's once in all orders", "[07][against]") {
    CHECK(slower_by_chance(1, 1, 1) == 0.5);
    CHECK(slower_by_chance(252, 5, 5) == Approx(1.0)); // C(10, 5)
    CHECK(slower_by_chance(10, 2, 3) == Approx(1.0));  // C(5, 3)
}

TEST_CASE("a walk is slower beyond doubt on the same machine where chance does not show it",
          "[07][against]") {
    const auto report = [](const Numbers& then, const Numbers& now) {
        return report_against({"then.json", then}, now);
    };
    const Numbers now = run_with(walk_json("grid", 2.0, 64));
    const AgainstReport faster = report(run_with(walk_json("grid", 1.0, 64)), now);
    CHECK(faster.slower == 0);
    CHECK_THAT(faster.text, contains_text("2.00 (2.00 to 2.00)  faster beyond doubt"));
    CHECK_THAT(report(now, now).text, contains_text("1.00 (1.00 to 1.00)  ranges overlap"));
    const AgainstReport slower = report(run_with(walk_json("grid", 4.0, 64)), now);
    CHECK(slower.slower == 1);
    CHECK(slower.rates == 1);
    CHECK_THAT(slower.text, contains_text("slower beyond doubt"));
    const AgainstReport other_rays = report(run_with(walk_json("grid", 4.0, 32)), now);
    CHECK(other_rays.slower == 0);
    CHECK_THAT(other_rays.text, contains_text("not compared: other rays"));

    const std::string embree = "Embree 3.13.5";
    const AgainstReport elsewhere = report(run_with(walk_json("grid", 4.0, 64), embree, "other"),
                                           run_with(walk_json("grid", 2.0, 64), embree));
    CHECK(elsewhere.slower == 0);
    CHECK_THAT(elsewhere.text, contains_text("another machine: other, 2 cores"));

    std::string many_then = walk_json("grid", 4.0, 64);
    std::string many_now = walk_json("grid", 2.0, 64);
    for (int i = 0; i < 12; ++i) { // with five rounds, 12 rows are not too many, and 13 are
        const std::string other = "," + walk_json("walk_" + std::to_string(i), 2.0, 64);
        CHECK(report(run_with(many_then), run_with(many_now)).slower == 1);
        many_then += other;
        many_now += other;
    }
    const AgainstReport by_chance = report(run_with(many_then), run_with(many_now));
    CHECK(by_chance.slower == 0);
    CHECK_THAT(by_chance.text,
               contains_text("slower in every round") && contains_text("take more --rounds"));
}
