#pragma once
#include <exception>
#include <rt/joiner.hpp>
#include <thread>
#include <vector>

namespace rt {

template <class Work>
void run_workers(int workers, const Work& work) {
    std::vector<std::exception_ptr> exceptions(static_cast<std::size_t>(workers));
    for (int worker = 0; worker < workers; ++worker) {
        try {
            work(worker);
        } catch (...) {
            exceptions[static_cast<std::size_t>(worker)] = std::current_exception();
        }
    }
    for (const std::exception_ptr& exception : exceptions)
        if (exception) std::rethrow_exception(exception);
}

}  // namespace rt
