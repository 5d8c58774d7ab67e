#include "run_knob.h"

#include "fault_rate.h"
#include "measure/stopwatch.h"
#include "basics/error.h"

#include <algorithm>

namespace raysteps {

namespace {

using Turns = std::vector<const Trial*>;

std::vector<Turns> by_family(const Knob& knob) {
    std::vector<Turns> families;
    for (const Trial& trial : knob.trials) {
        const auto place = std::find_if(families.begin(), families.end(), [&](const Turns& turns) {
            return turns.front()->family == trial.family;
        });
        if (place == families.end()) {
            families.push_back({&trial});
        } else {
            place->push_back(&trial);
        }
    }
    return families;
}

void check_equal_work(const Knob& knob, const Turns& turns) {
    for (const Trial* trial : turns) {
        if (trial->timed_cases != turns.front()->timed_cases || trial->timed_cases == 0) {
            throw Error(ExitCode::check_failed,
                        knob.name + ", " + trial->family + ": " + trial->method + " has " +
                            std::to_string(trial->timed_cases) + " cases and " +
                            turns.front()->method + " " +
                            std::to_string(turns.front()->timed_cases) +
                            ", so their times cannot be compared. That is a fault of Raysteps.");
        }
    }
}

void check_same_answers(const Knob& knob, const Measurement& measurement) {
    if (knob.kind == KnobKind::speed_only && total_fault(measurement.findings).count > 0) {
        throw Error(ExitCode::check_failed,
                    knob.name + ", " + measurement.family + ": " + measurement.method + " gives " +
                        std::to_string(total_fault(measurement.findings).count) +
                        " other answers, and should change the speed only. That is a fault of "
                        "Raysteps.");
    }
}

Cost cost_of(std::vector<double> seconds, std::size_t cases) {
    for (double& time : seconds) {
        time *= 1e9 / static_cast<double>(cases);
    }
    return measured_range(std::move(seconds));
}

} // namespace

KnobResult run_knob(const Knob& knob, int rounds, Clock clock,
                    const std::function<void(double part_done)>& progress) {
    if (rounds < 1) {
        throw InputError("--rounds " + std::to_string(rounds) +
                         ": there is nothing to measure. Take 1 or more.");
    }
    KnobResult result{knob.name,          knob.question, knob.source, knob.unit_of_cases,
                      knob.unit_of_error, knob.kind,     {},          knob.pictures};
    const double steps = static_cast<double>(knob.trials.size()) * (rounds + 2);
    double done = 0.0;
    for (const Turns& turns : by_family(knob)) {
        check_equal_work(knob, turns);
        std::vector<std::vector<double>> seconds(turns.size());
        for (int round = 0; round <= rounds; ++round) {
            for (std::size_t i = 0; i < turns.size(); ++i) {
                const Seconds taken = seconds_of(turns[i]->run);
                if (round > 0) { // the first one warms caches, and compiles
                    seconds[i].push_back(clock == Clock::wall ? taken.clock : taken.cpu);
                }
                progress(++done / steps);
            }
        }
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const Trial& trial = *turns[i];
            result.measurements.push_back({trial.method, trial.family, trial.timed_cases,
                                           trial.examine(),
                                           cost_of(seconds[i], trial.timed_cases)});
            check_same_answers(knob, result.measurements.back());
            progress(++done / steps);
        }
    }
    return result;
}

} // namespace raysteps
