#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace companion {

// Calls work(0) ... work(count - 1), as many at a time as there are cores. If a call throws, no
// further call begins, and the first exception is thrown again.
template <class Work>
void in_parallel(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr first;
    std::mutex noting;
    const auto work_on = [&] {
        for (std::size_t i = next++; i < count; i = next++) try {
                work(i);
            } catch (...) {
                const std::lock_guard lock{noting};
                if (!first) first = std::current_exception();
                next = count;
            }
    };
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    try {
        for (std::size_t i = 1; i < std::min(cores, count); ++i) threads.emplace_back(work_on);
    } catch (const std::system_error&) {  // no more can be started: those that run do the work
    }
    work_on();
    for (std::thread& thread : threads) thread.join();
    if (first) std::rethrow_exception(first);
}

}  // namespace companion
