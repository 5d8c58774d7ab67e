#include "trade_off.h"

#include "basics/error.h"
#include "measure/contest.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace raysteps {

namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
    }
}

constexpr double million = 1e6;
constexpr double normal_95 = 1.959963984540054; // 97.5 % of a normal distribution lie below
constexpr double rule_of_three = 3.0;           // -ln 0.05

using Turns = std::vector<const MethodTrial*>;

std::vector<Turns> by_family(const TradeOffTrials& trade_off) {
    std::vector<Turns> families;
    for (const MethodTrial& trial : trade_off.trials) {
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

void check_equal_work(const TradeOffTrials& trade_off, const Turns& turns) {
    for (const MethodTrial* trial : turns) {
        if (trial->timed_cases != turns.front()->timed_cases || trial->timed_cases == 0) {
            throw Error(
                ExitCode::check_failed,
                trade_off.name + ", " + trial->family + ": " + trial->method + " has " +
                    std::to_string(trial->timed_cases) + " cases and " + turns.front()->method +
                    " " + std::to_string(turns.front()->timed_cases) +
                    ", so their times cannot be compared. This is a bug in Raysteps; please "
                    "report it.");
        }
    }
}

void check_same_answers(const TradeOffTrials& trade_off, const Measurement& measurement) {
    if (trade_off.kind == TradeOffKind::speed_only && total_fault(measurement.findings).count > 0) {
        throw Error(ExitCode::check_failed,
                    trade_off.name + ", " + measurement.family + ": " + measurement.method +
                        " gives " + std::to_string(total_fault(measurement.findings).count) +
                        " other answers, and should change the speed only. This is a bug in "
                        "Raysteps; please report it.");
    }
}

} // namespace

std::vector<std::string> methods_of(const TradeOffResult& result) {
    std::vector<std::string> names;
    for (const Measurement& measurement : result.measurements) {
        add_once(names, measurement.method);
    }
    return names;
}

std::vector<std::string> families_of(const TradeOffResult& result) {
    std::vector<std::string> names;
    for (const Measurement& measurement : result.measurements) {
        add_once(names, measurement.family);
    }
    return names;
}

const Measurement* measurement_of(const TradeOffResult& result, const std::string& method,
                                  const std::string& family) {
    for (const Measurement& measurement : result.measurements) {
        if (measurement.method == method && measurement.family == family) {
            return &measurement;
        }
    }
    return nullptr;
}

FaultRate fault_rate(std::size_t count, std::size_t of) {
    if (of == 0) {
        return {0.0, 0.0, million};
    }
    const double n = static_cast<double>(of);
    const double share = static_cast<double>(count) / n;
    if (count == 0) {
        return {0.0, 0.0, std::min(1.0, rule_of_three / n) * million};
    }
    const double z2 = normal_95 * normal_95;
    const double center = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
    const double half =
        normal_95 / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
    return {share * million, std::max(0.0, center - half) * million,
            std::min(1.0, center + half) * million};
}

std::string to_string(const FaultRate& rate) {
    if (is_one_sided(rate)) {
        return fmt::format("0 (<{:.0f})", std::ceil(rate.highest));
    }
    return fmt::format("{:.0f} ({:.0f} to {:.0f})", rate.counted, rate.lowest, rate.highest);
}

Fault total_fault(const Findings& findings) {
    Fault total{"faults", 0, 0};
    for (const Fault& fault : findings.faults) {
        total.count += fault.count;
        total.of = std::max(total.of, fault.of);
    }
    return total;
}

TradeOffResult measure_trade_off(const TradeOffTrials& trade_off, int rounds, Clock clock,
                                 const std::function<void(double part_done)>& progress) {
    TradeOffResult result{trade_off};
    const double trials = static_cast<double>(trade_off.trials.size());
    double done = 0.0; // trials
    for (const Turns& turns : by_family(trade_off)) {
        check_equal_work(trade_off, turns);
        std::vector<Contender> contenders;
        for (const MethodTrial* trial : turns) {
            contenders.push_back({trial->method, trial->run});
        }
        const double own = static_cast<double>(turns.size());
        const std::vector<ContestTimes> times =
            run_contest(contenders, rounds, [&](double part_done) {
                progress((done + 0.9 * own * part_done) / trials);
            });
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const MethodTrial& trial = *turns[i];
            const Cost cost = over_rounds(times[i], [&](const Seconds& seconds) {
                return (clock == Clock::wall ? seconds.clock : seconds.cpu) * 1e9 /
                       static_cast<double>(trial.timed_cases);
            });
            result.measurements.push_back(
                {trial.method, trial.family, trial.timed_cases, trial.examine(), cost});
            check_same_answers(trade_off, result.measurements.back());
        }
        done += own;
        progress(done / trials);
    }
    return result;
}

} // namespace raysteps
