#pragma once
#include <exception>
#include <rt/joiner.hpp>
#include <thread>
#include <vector>

namespace rt {

template <class Work>
void run_workers(int workers, const Work& work) {
    std::vector<std::exception_ptr> exceptions(static_cast<std::size_t>(workers));
    {
        std::vector<std::thread> threads;
        const Joiner join_all{threads};
        for (int worker = 0; worker < workers; ++worker)
            threads.emplace_back([&work, &exceptions, worker] {
                try {
                    work(worker);
                } catch (...) {
                    exceptions[static_cast<std::size_t>(worker)] = std::current_exception();
                }
            });
    }
}

}  // namespace rt
