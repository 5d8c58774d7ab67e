#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace raysteps {

// Calls work(i) once for each i < count, on all cores, in any order. The calls must not disturb
// each other, and must not throw.
template <class Work>
void on_all_cores(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto take_work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            work(i);
        }
    };
    std::vector<std::jthread> helpers; // their destructors wait for them
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) {
        helpers.emplace_back(take_work);
    }
    take_work();
}

} // namespace raysteps
