#include "08_accuracy/verdict.h"

#include "basics/error.h"
#include "catch.h"
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
TradeOffResult five_methods() {
    TradeOffResult result;
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

TradeOffTrials trade_off_of(std::size_t cases_of_second) {
    TradeOffTrials trade_off;
    trade_off.name = "example";
    const auto answer = [] { return Findings{{{"missed", 1, 10}}, std::nullopt, {}}; };
    trade_off.trials = {{"a", "family", 10, [] {}, answer},
                        {"b", "family", cases_of_second, [] {}, answer}};
    return trade_off;
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
    TradeOffResult hopeless = five_methods();
    for (Measurement& one : hopeless.measurements) {
        one.findings.faults[0].count = 7;
    }
    CHECK(for_need(advise(hopeless), "default").methods.empty());
    hopeless.kind = TradeOffKind::speed_only;
    CHECK(advise(hopeless).empty());
}

TEST_CASE("advice for a closed mesh goes by the leaks that were counted and by no name",
          "[08][verdict]") {
    TradeOffResult result;
    result.name = "example";
    result.on_closed_mesh = true;
    result.measurements = {measured("watertight, but leaking", "usual", {10, 9, 11}, 0, 1.0),
                           measured("watertight, but leaking", "hard", {10, 9, 11}, 1, 1.0),
                           measured("plain", "usual", {20, 19, 21}, 0, 1.0),
                           measured("plain", "hard", {20, 19, 21}, 0, 1.0)};
    CHECK(for_need(advise(result), "closed mesh").methods == std::vector<std::string>{"plain"});
    // A hit too many is a fault, and no leak.
    result.measurements.back().findings.faults.push_back({"false", 5, 100000});
    CHECK(for_need(advise(result), "closed mesh").methods == std::vector<std::string>{"plain"});
    CHECK(for_need(advise(result), "default").methods.empty());
    // Nothing was counted, so nothing is known.
    for (Measurement& one : result.measurements) {
        one.findings.faults.clear();
    }
    CHECK(for_need(advise(result), "closed mesh").methods.empty());
}

TEST_CASE("where no mesh is closed nothing is said of closed meshes", "[08][verdict]") {
    TradeOffResult open = five_methods();
    open.name = "triangle";
    for (const Advice& one : advise(open)) {
        CHECK(one.need != "closed mesh");
    }
}

TEST_CASE("methods with other numbers of cases are not compared", "[08][runner]") {
    const auto quiet = [](double) {};
    const TradeOffResult result = measure_trade_off(trade_off_of(10), 3, Clock::wall, quiet);
    REQUIRE(result.measurements.size() == 2);
    CHECK(result.measurements[1].method == "b");
    CHECK_THROWS_WITH(measure_trade_off(trade_off_of(11), 3, Clock::wall, quiet),
                      contains_text("b has 11 cases and a 10"));
    CHECK_THAT(error_of([&] { measure_trade_off(trade_off_of(10), 0, Clock::wall, quiet); }),
               contains_text("--rounds 0"));
}

TEST_CASE("a trade-off that changes only the speed may have no fault", "[08][runner]") {
    TradeOffTrials trade_off = trade_off_of(10);
    trade_off.kind = TradeOffKind::speed_only;
    CHECK_THROWS_AS(measure_trade_off(trade_off, 1, Clock::wall, [](double) {}), Error);
}

TEST_CASE("the runner drops the first round and takes turns", "[08][runner]") {
    std::string turns;
    TradeOffTrials trade_off;
    const auto none = [] { return Findings{}; };
    trade_off.trials = {{"a", "x", 1, [&] { turns += 'a'; }, none},
                        {"b", "x", 1, [&] { turns += 'b'; }, none}};
    const TradeOffResult result = measure_trade_off(trade_off, 2, Clock::wall, [](double) {});
    CHECK(turns == "ababab");
    CHECK(result.measurements[0].cost.lowest <= result.measurements[0].cost.median);
    CHECK(result.measurements[0].cost.median <= result.measurements[0].cost.highest);
}
