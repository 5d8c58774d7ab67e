#pragma once

#include <chrono>
#include <utility>

namespace raysteps {

// What the work gives, and the seconds on the clock that it took.
template <class Work>
auto timed(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return std::pair{std::move(result), seconds.count()};
}

} // namespace raysteps
