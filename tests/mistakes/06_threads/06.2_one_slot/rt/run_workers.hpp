#pragma once
#include <exception>
#include <mutex>
#include <rt/joiner.hpp>
#include <thread>
#include <vector>

namespace rt {

template <class Work>
void run_workers(int workers, const Work& work) {
    std::vector<std::exception_ptr> exceptions(static_cast<std::size_t>(workers));
    std::mutex mutex;
    {
        std::vector<std::thread> threads;
        const Joiner join_all{threads};
        for (int worker = 0; worker < workers; ++worker)
            threads.emplace_back([&work, &exceptions, &mutex, worker] {
                try {
                    work(worker);
                } catch (...) {
                    const std::lock_guard lock{mutex};
                    exceptions[0] = std::current_exception();
                }
            });
    }
    for (const std::exception_ptr& exception : exceptions)
        if (exception) std::rethrow_exception(exception);
}

}  // namespace rt
