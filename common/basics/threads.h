#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace raysteps {

inline constexpr unsigned all_cores = 0;

// Calls work(i) once for each i < count, on so many threads, in any order. The calls must not
// disturb each other. What one of them throws is thrown here when all threads have stopped.
template <class Work>
void on_threads(unsigned threads, std::size_t count, const Work& work) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto take_work = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) {
                work(i);
            }
        } catch (...) {
            next = count;
            const std::lock_guard lock(failure_mutex);
            failure = std::current_exception();
        }
    };
    {
        const unsigned wanted =
            threads == all_cores ? std::thread::hardware_concurrency() : threads;
        std::vector<std::jthread> helpers; // their destructors wait for them
        for (unsigned i = 1; i < wanted && i < count; ++i) {
            helpers.emplace_back(take_work);
        }
        take_work();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

// The same in parts: work(begin, end) for ranges of at most `part` that together are [0, count).
template <class Work>
void in_parts(unsigned threads, std::size_t count, std::size_t part, const Work& work) {
    on_threads(threads, (count + part - 1) / part,
               [&](std::size_t i) { work(i * part, std::min((i + 1) * part, count)); });
}

} // namespace raysteps
