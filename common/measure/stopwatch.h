#pragma once

namespace raysteps {

// Seconds on the clock, and seconds that all threads of this process spent on CPUs. On a machine
// that others use too, the second tells whether the first was held up.
struct Seconds {
    double clock = 0.0;
    double cpu = 0.0;
};

// Since some fixed moment: only differences mean anything.
Seconds seconds_now();

template <class Work>
Seconds seconds_of(const Work& work) {
    const Seconds start = seconds_now();
    work();
    const Seconds end = seconds_now();
    return {end.clock - start.clock, end.cpu - start.cpu};
}

} // namespace raysteps
