#pragma once

#include "basics/statistics.h"
#include "gpu/limits.h"
#include "image/image.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raysteps {

// What went wrong in one way, in so many of so many cases: "missed", 3 of 16384.
struct Fault {
    std::string name;
    std::size_t count = 0;
    std::size_t of = 0;
};

// How often something happens, in millionths: as it was counted, and between which bounds the truth
// lies. Where there was a fault, with a confidence of 95 % for the two of them: two-sided. Where
// there was none, nothing lies below, and the upper one alone has the 95 %: one-sided. So an upper
// bound of one kind is not to be compared with one of the other as if they said the same.
struct FaultRate {
    double counted = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
};

// Of 0 in n the upper bound is 3 / n, one-sided (Hanley and Lippman-Hand, "If Nothing Goes Wrong,
// Is Everything All Right?", 1983); else the bounds are Wilson's, two-sided ("Probable Inference,
// the Law of Succession, and Statistical Inference", 1927). Of no case at all nothing is known: 0
// to a million.
FaultRate fault_rate(std::size_t count, std::size_t of);

// Whether its upper bound stands alone.
inline bool is_one_sided(const FaultRate& rate) {
    return rate.counted == 0.0;
}

// `0 (<183)`, `101637 (101045 to 102232)`: per million.
std::string to_string(const FaultRate& rate);

// What else was found: "rmse", 0.02.
struct Measure {
    std::string name;
    double value = 0.0;
};

// How wrong a method was on one family of cases.
struct Findings {
    std::vector<Fault> faults{};
    std::optional<Summary> error{}; // in the unit of the trade-off
    std::vector<Measure> measures{};
};

// All faults of the findings together; each case has at most one.
Fault total_fault(const Findings& findings);

// Nanoseconds per case, over the rounds of a contest.
using Cost = MeasuredRange;

// Whether every round of a was cheaper than every round of b. Where neither is, their ranges
// overlap, and no rank is given.
inline bool is_cheaper(const Cost& a, const Cost& b) {
    return lies_below(a, b);
}

// One method at work on one family of cases.
struct MethodTrial {
    std::string method;
    std::string family;
    std::size_t timed_cases = 0;       // that one run works on
    std::function<void()> run;         // what is timed; ends when the work is done
    std::function<Findings()> examine; // not timed, and may look at more cases
};

struct TradeOffPicture {
    std::string caption;
    Image image;
};

// How the methods of a trade-off are judged.
enum class TradeOffKind {
    methods,      // by their faults and errors: the same thing computed in several ways
    pictures,     // by how alike the picture looks: more or less of the same work
    illustration, // not at all: what the faults of another trade-off look like
    speed_only,   // by the time alone: no answer may change
};

// A choice between methods whose answers differ in accuracy or in cost.
struct TradeOff {
    std::string name;     // triangle
    std::string question; // that a person has
    std::string source{}; // of figures that others published, where there are such
    std::string unit_of_cases;
    std::string unit_of_error{}; // empty where there are only faults
    TradeOffKind kind = TradeOffKind::methods;
    bool on_closed_mesh = false; // so a missed hit is a leak
    std::vector<TradeOffPicture> pictures{};
};

// A trade-off before it is measured.
struct TradeOffTrials : TradeOff {
    std::vector<MethodTrial> trials{};
};

struct Measurement {
    std::string method;
    std::string family;
    std::size_t timed_cases = 0;
    Findings findings;
    Cost cost;
};

// And when it was.
struct TradeOffResult : TradeOff {
    std::vector<Measurement> measurements{}; // family by family
};

// The names in the order in which they first appear.
std::vector<std::string> methods_of(const TradeOffResult& result);
std::vector<std::string> families_of(const TradeOffResult& result);

// What was measured of the method on the family; null where it took no part.
const Measurement* measurement_of(const TradeOffResult& result, const std::string& method,
                                  const std::string& family);

// How much work the comparisons make.
struct Effort {
    std::size_t judged_rays = 16384; // of each family
    std::size_t timed_rays = 4096;   // the first of them
    int rounds = 9;                  // after one that is dropped
    int picture_size = 96;           // pixels along a side
    int finest_grid = 512;           // cells across, where crossings are compared
    int most_samples = 3;            // along each side of a pixel, where samples are compared
    int seed = 1;
    Limits limits{};
};

// Which clock tells how long something took: that on the wall, or the processor time of this
// process, which is steadier where others use the machine too, but does not see a GPU.
enum class Clock { wall, processor };

// Measures all methods of a trade-off: a contest for each family of cases (measure/contest.h),
// after which each is examined. Throws InputError where there is no round, and Error with exit code
// 1 where two methods of a family do not have the same number of cases to work on, or where answers
// differ that must not.
TradeOffResult measure_trade_off(const TradeOffTrials& trade_off, int rounds, Clock clock,
                                 const std::function<void(double part_done)>& progress);

} // namespace raysteps
