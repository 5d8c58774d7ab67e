#pragma once

#include "basics/statistics.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace raysteps {

// Seconds on the clock, and seconds that all threads of this process spent on CPUs. On a machine
// that others use too, the second tells whether the first was held up.
struct Seconds {
    double clock = 0.0;
    double cpu = 0.0;
};

// Who takes part in a contest: a function by a name.
struct Contender {
    std::string name;
    std::function<void()> run;       // returns when the work is done, on the GPU as well
    std::function<void()> prepare{}; // before each run, and not timed
};

// What one contender took, round by round.
struct ContestTimes {
    std::string name;
    std::vector<Seconds> rounds;
};

// Times all contenders in turn: each round runs every one of them once, so that what slows the
// machine for a while slows them all. A first round, which warms the caches and in which drivers
// compile, is dropped. The times are in the order of the contenders. Throws InputError unless there
// is a round.
std::vector<ContestTimes> run_contest(
    std::span<const Contender> contenders, int rounds,
    const std::function<void(double part_done)>& progress = [](double) {});

// Median, lowest and highest over the rounds of what `value` makes of the seconds of one: a rate, a
// cost per ray, the number of busy cores.
template <class Value>
MeasuredRange over_rounds(const ContestTimes& times, const Value& value) {
    std::vector<double> values;
    for (const Seconds& seconds : times.rounds) {
        values.push_back(value(seconds));
    }
    return measured_range(std::move(values));
}

inline MeasuredRange clock_seconds(const ContestTimes& times) {
    return over_rounds(times, [](const Seconds& seconds) { return seconds.clock; });
}

inline MeasuredRange cpu_seconds(const ContestTimes& times) {
    return over_rounds(times, [](const Seconds& seconds) { return seconds.cpu; });
}

// How fast one contender was as a multiple of another, where they did that much work in a round:
// round by round, so that what slows the machine for a while slows both. `spent` says which seconds
// count: &Seconds::clock or &Seconds::cpu. Both must have been in one contest.
MeasuredRange speed_ratio(const ContestTimes& ours, double our_work, const ContestTimes& theirs,
                          double their_work, double Seconds::*spent);

// What the work takes by itself, once, in no contest.
Seconds seconds_of(const std::function<void()>& work);

} // namespace raysteps
