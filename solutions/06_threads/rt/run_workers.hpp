#pragma once
#include <exception>
#include <rt/join_guard.hpp>
#include <thread>
#include <vector>

namespace rt {

// Calls work(0), work(1), ... work(workers - 1), each in a thread of its own, all at the same time,
// and returns when all have ended. If some calls throw, the exception of the worker with the lowest
// number is thrown again here, after all have ended. If a thread cannot be started, the exception
// of std::thread reaches the caller, after the running threads have ended. For 0 workers there is
// nothing to do.
template <class Work>
void run_workers(int workers, const Work& work) {
    // A slot for each worker: no two threads write to the same memory.
    std::vector<std::exception_ptr> exceptions(static_cast<std::size_t>(workers));
    {
        std::vector<std::thread> threads;
        const JoinGuard join_all{threads};
        for (int worker = 0; worker < workers; ++worker)
            threads.emplace_back([&work, &exceptions, worker] {
                try {
                    work(worker);
                } catch (...) {
                    exceptions[static_cast<std::size_t>(worker)] = std::current_exception();
                }
            });
    }
    for (const std::exception_ptr& exception : exceptions)
        if (exception) std::rethrow_exception(exception);
}

}  // namespace rt
