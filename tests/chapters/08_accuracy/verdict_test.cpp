#include "08_accuracy/verdict.h"

#include "08_accuracy/run_knob.h"
#include "catch.h"
#include "basics/error.h"
#include "08_accuracy/base64.h"
#include "08_accuracy/scatter_plot.h"
#include "support/error_of.h"

#include <algorithm>

using namespace raysteps;

namespace {

Measurement measured(const std::string& method, const std::string& family, const Cost& cost,
                     std::size_t faults, double error) {
    return {method,
            family,
            100,
            {{{"missed", faults, 100000}}, Summary{error, error, error}, {}},
            cost};
}

// Fast and wrong, sure, sure and slow, exact and slow, wrong and slow.
KnobResult five_methods() {
    KnobResult result;
    result.name = "example";
    for (const std::string family : {"usual", "hard"}) {
        const std::size_t bad = family == "hard" ? 500 : 0;
        result.measurements.push_back(measured("fast", family, {10, 9, 11}, bad, 4.0));
        result.measurements.push_back(measured("sure", family, {13, 12, 14}, 0, 3.0));
        result.measurements.push_back(measured("sure too", family, {13.5, 12.5, 15}, 0, 3.0));
        result.measurements.push_back(measured("exact", family, {20, 19, 21}, 0, 0.5));
        result.measurements.push_back(measured("worst", family, {30, 29, 31}, bad, 4.0));
    }
    return result;
}

const MethodSummary& named(const std::vector<MethodSummary>& all, const std::string& name) {
    return *std::find_if(all.begin(), all.end(),
                         [&](const MethodSummary& one) { return one.method == name; });
}

const Advice& for_need(const std::vector<Advice>& all, const std::string& need) {
    return *std::find_if(all.begin(), all.end(),
                         [&](const Advice& one) { return one.need == need; });
}

Knob knob_of(std::size_t cases_of_second) {
    Knob knob;
    knob.name = "example";
    const auto answer = [] { return Findings{{{"missed", 1, 10}}, std::nullopt, {}}; };
    knob.trials = {{"a", "family", 10, [] {}, answer},
                   {"b", "family", cases_of_second, [] {}, answer}};
    return knob;
}

} // namespace

TEST_CASE("what is surely worse in one way and surely better in none is dominated",
          "[08][verdict]") {
    const std::vector<MethodSummary> all = summarize_methods(five_methods());
    REQUIRE(all.size() == 5);
    CHECK(named(all, "fast").worst_family == "hard");
    CHECK(named(all, "fast").faults->counted == Approx(5000.0).margin(1e-6));
    CHECK(named(all, "exact").cost.median == Approx(20.0).margin(1e-12));
    CHECK_FALSE(is_dominated(named(all, "fast"), all));
    CHECK_FALSE(is_dominated(named(all, "sure"), all));
    CHECK_FALSE(is_dominated(named(all, "sure too"), all)); // its range overlaps
    CHECK_FALSE(is_dominated(named(all, "exact"), all));
    CHECK(is_dominated(named(all, "worst"), all));
}

TEST_CASE("advice names the cheapest that will do and those it cannot be told from",
          "[08][verdict]") {
    const std::vector<Advice> advice = advise(five_methods());
    CHECK(for_need(advice, "preview").methods == std::vector<std::string>{"fast"});
    CHECK(for_need(advice, "default").methods == std::vector<std::string>{"sure", "sure too"});
    CHECK(for_need(advice, "reference").methods == std::vector<std::string>{"exact"});
    KnobResult hopeless = five_methods();
    for (Measurement& one : hopeless.measurements) {
        one.findings.faults[0].count = 7;
    }
    CHECK(for_need(advise(hopeless), "default").methods.empty());
    hopeless.kind = KnobKind::speed_only;
    CHECK(advise(hopeless).empty());
}

TEST_CASE("methods with other numbers of cases are not compared", "[08][runner]") {
    const auto quiet = [](double) {};
    const KnobResult result = run_knob(knob_of(10), 3, Clock::wall, quiet);
    REQUIRE(result.measurements.size() == 2);
    CHECK(result.measurements[1].method == "b");
    CHECK_THROWS_WITH(run_knob(knob_of(11), 3, Clock::wall, quiet),
                      contains_text("b has 11 cases and a 10"));
    CHECK_THAT(error_of([&] { run_knob(knob_of(10), 0, Clock::wall, quiet); }),
               contains_text("--rounds 0"));
}

TEST_CASE("a knob that changes only the speed may have no fault", "[08][runner]") {
    Knob knob = knob_of(10);
    knob.kind = KnobKind::speed_only;
    CHECK_THROWS_AS(run_knob(knob, 1, Clock::wall, [](double) {}), Error);
}

TEST_CASE("the runner drops the first round and takes turns", "[08][runner]") {
    std::string turns;
    Knob knob;
    const auto none = [] { return Findings{}; };
    knob.trials = {{"a", "x", 1, [&] { turns += 'a'; }, none},
                   {"b", "x", 1, [&] { turns += 'b'; }, none}};
    const KnobResult result = run_knob(knob, 2, Clock::wall, [](double) {});
    CHECK(turns == "ababab");
    CHECK(result.measurements[0].cost.lowest <= result.measurements[0].cost.median);
    CHECK(result.measurements[0].cost.median <= result.measurements[0].cost.highest);
}

TEST_CASE("bytes become text as RFC 4648 has it", "[08][page]") {
    CHECK(to_base64("").empty());
    CHECK(to_base64("f") == "Zg==");
    CHECK(to_base64("fo") == "Zm8=");
    CHECK(to_base64("foo") == "Zm9v");
    CHECK(to_base64("foobar") == "Zm9vYmFy");
}

TEST_CASE("a plot has a mark and a label for each method and no raw sign", "[08][page]") {
    const ScatterPlot plot{"a < b",
                           "x",
                           "y",
                           {{"first & best", "hint", 1, 1, 1, 10, 9, 11, false},
                            {"bound", "", 2, 2, 2, 0, 0, 5, true}}};
    const std::string svg = to_svg(plot);
    CHECK_THAT(svg, contains_text("a &lt; b"));
    CHECK_THAT(svg, contains_text("first &amp; best"));
    CHECK_THAT(svg, contains_text("<circle")); // of the one
    CHECK_THAT(svg, contains_text("<path"));   // an upper bound, of the other
    CHECK_THAT(svg, contains_text("<g class='dominated'>"));
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(to_svg({}).empty());
}
