#pragma once
#include <exception>
#include <rt/join_guard.hpp>
#include <rt/todo.hpp>
#include <thread>
#include <vector>

namespace rt {

// Exercise 06.2. Calls work(0), work(1), ... work(workers - 1), each in a thread of its own, all at
// the same time, and returns when all have ended. For 0 workers there is nothing to do.
// Star: if some calls throw anything, the exception of the worker with the lowest number is thrown
// again here, after all have ended. If a thread cannot be started, the exception of std::thread
// reaches the caller, after the running threads have ended. Several calls of run_workers may run at
// the same time.
template <class Work>
void run_workers(int workers, const Work& work) {
    rt::todo("06.2", workers, work);
}

}  // namespace rt
