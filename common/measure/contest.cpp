#include "measure/contest.h"

#include "basics/error.h"

#include <sys/resource.h>

#include <chrono>

namespace raysteps {

namespace {

double seconds_in(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

// Since some fixed moment: only differences mean anything.
Seconds seconds_now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto clock = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(clock).count(),
            seconds_in(usage.ru_utime) + seconds_in(usage.ru_stime)};
}

} // namespace

Seconds seconds_of(const std::function<void()>& work) {
    const Seconds start = seconds_now();
    work();
    const Seconds end = seconds_now();
    return {end.clock - start.clock, end.cpu - start.cpu};
}

MeasuredRange speed_ratio(const ContestTimes& ours, double our_work, const ContestTimes& theirs,
                          double their_work, double Seconds::*spent) {
    //# exercise 10.6: how many times as fast
    std::vector<double> ratios;
    for (std::size_t round = 0; round < ours.rounds.size(); ++round) {
        const double our_speed = our_work / (ours.rounds[round].*spent);
        const double their_speed = their_work / (theirs.rounds[round].*spent);
        ratios.push_back(our_speed / their_speed);
    }
    return measured_range(std::move(ratios));
    //# stub: const double our_speed = our_work / (ours.rounds.front().*spent);
    //# stub: const double their_speed = their_work / (theirs.rounds.front().*spent);
    //# stub: return measured_range({our_speed / their_speed});
    //# end
}

std::vector<ContestTimes> run_contest(std::span<const Contender> contenders, int rounds,
                                      const std::function<void(double part_done)>& progress) {
    if (rounds < 1) {
        throw InputError("--rounds " + std::to_string(rounds) +
                         ": there is nothing to measure. Take 1 or more.");
    }
    std::vector<ContestTimes> times;
    for (const Contender& contender : contenders) {
        times.push_back({contender.name, {}});
    }
    const double runs = static_cast<double>(contenders.size()) * (rounds + 1);
    double done = 0.0;
    //# exercise 7.5: a hunt, for what a benchmark lies about
    for (int round = 0; round <= rounds; ++round) {
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            if (contenders[i].prepare) {
                contenders[i].prepare();
            }
            const Seconds seconds = seconds_of(contenders[i].run);
            if (round > 0) {
                times[i].rounds.push_back(seconds);
            }
            progress(++done / runs);
        }
    }
    //# end
    return times;
}

} // namespace raysteps
