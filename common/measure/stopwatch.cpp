#include "measure/stopwatch.h"

#include <sys/resource.h>

#include <chrono>

namespace raysteps {

namespace {

double seconds_in(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

} // namespace

Seconds seconds_now() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto clock = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(clock).count(),
            seconds_in(usage.ru_utime) + seconds_in(usage.ru_stime)};
}

} // namespace raysteps
