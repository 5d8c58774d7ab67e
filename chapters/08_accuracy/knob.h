#pragma once

#include "image/image.h"
#include "basics/statistics.h"

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

// What else was found: "rmse", 0.02.
struct Measure {
    std::string name;
    double value = 0.0;
};

// How wrong a method was on one family of cases.
struct Findings {
    std::vector<Fault> faults{};
    std::optional<Summary> error{}; // in the unit of the knob
    std::vector<Measure> measures{};
};

// Nanoseconds a case, over the rounds of a measurement.
using Cost = MeasuredRange;

// Whether every round of a was cheaper than every round of b. Where neither is, their ranges
// overlap, and no rank is given.
inline bool is_cheaper(const Cost& a, const Cost& b) {
    return lies_below(a, b);
}

// One method at work on one family of cases.
struct Trial {
    std::string method;
    std::string family;
    std::size_t timed_cases = 0;       // that one run works on
    std::function<void()> run;         // what is timed; ends when the work is done
    std::function<Findings()> examine; // not timed, and may look at more cases
};

struct KnobPicture {
    std::string caption;
    Image image;
};

// By what the methods of a knob are judged.
enum class KnobKind {
    methods,      // by their faults and errors: the same thing computed in several ways
    pictures,     // by how alike the picture looks: more or less of the same work
    illustration, // what the faults of another knob look like; no advice follows
    speed_only,   // by the time alone: no answer may change
};

// A choice between methods whose answers differ in accuracy or in cost.
struct Knob {
    std::string name;     // triangle
    std::string question; // that a person has
    std::string source{}; // of figures that others published, where there are such
    std::string unit_of_cases;
    std::string unit_of_error{}; // empty where there are only faults
    KnobKind kind = KnobKind::methods;
    std::vector<Trial> trials{};
    std::vector<KnobPicture> pictures{};
};

struct Measurement {
    std::string method;
    std::string family;
    std::size_t timed_cases = 0;
    Findings findings;
    Cost cost;
};

struct KnobResult {
    std::string name;
    std::string question;
    std::string source;
    std::string unit_of_cases;
    std::string unit_of_error;
    KnobKind kind = KnobKind::methods;
    std::vector<Measurement> measurements; // family by family
    std::vector<KnobPicture> pictures;
};

// The names in the order in which they first appear.
std::vector<std::string> methods_of(const KnobResult& result);
std::vector<std::string> families_of(const KnobResult& result);

// What was measured of the method on the family; nothing where it took no part.
const Measurement* measurement_of(const KnobResult& result, const std::string& method,
                                  const std::string& family);

} // namespace raysteps
