#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace raysteps {

// Calls work(i) once for each i < count, on so many threads (0: as many as the machine has cores),
// in any order. The calls must not disturb
// each other. What one of them throws is thrown here when all threads have stopped.
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
        const unsigned wanted = threads == 0 ? std::thread::hardware_concurrency() : threads;
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

} // namespace raysteps
