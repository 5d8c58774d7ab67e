#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace raysteps {

// Calls work(begin, end) for parts of [0, count) that together are all of it, on so many threads
// (0: as many as the machine has cores), in any order. The calls must not disturb each other, and
// must not throw.
template <class Work>
void in_parts(std::size_t count, std::size_t part, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto take_parts = [&] {
        for (std::size_t begin = next.fetch_add(part); begin < count;
             begin = next.fetch_add(part)) {
            work(begin, std::min(begin + part, count));
        }
    };
    const std::size_t parts = (count + part - 1) / part;
    const unsigned wanted = threads == 0 ? std::thread::hardware_concurrency() : threads;
    std::vector<std::jthread> helpers; // their destructors wait for them
    for (unsigned i = 1; i < wanted && i < parts; ++i) {
        helpers.emplace_back(take_parts);
    }
    take_parts();
}

} // namespace raysteps
