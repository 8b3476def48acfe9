#pragma once
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace app {

// How many threads can run at the same time, up to `wanted`. The system may allow fewer
// (ulimit -u); it is better to know this before the work starts than when half of it is done.
inline int threads_that_start(int wanted) {
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(wanted));
    std::mutex all_run;
    {
        const std::lock_guard hold{all_run};
        try {
            for (int i = 0; i < wanted; ++i)
                threads.emplace_back([&] { const std::lock_guard wait{all_run}; });
        } catch (const std::system_error&) {
        }
    }
    for (std::thread& thread : threads) thread.join();
    return static_cast<int>(threads.size());
}

}  // namespace app
