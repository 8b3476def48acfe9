#pragma once
#include <exception>
#include <rt/join_guard.hpp>
#include <thread>
#include <vector>

namespace rt {

template <class Work>
void run_workers(int workers, const Work& work) {
    std::vector<std::thread> threads;
    for (int worker = 0; worker < workers; ++worker)
        threads.emplace_back([&work, worker] { work(worker); });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace rt
