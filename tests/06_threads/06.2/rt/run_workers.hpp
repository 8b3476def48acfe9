#pragma once
#include <functional>

namespace answer {

void run_workers(int workers, const std::function<void(int)>& work);

}  // namespace answer

namespace rt {

using answer::run_workers;

// Threads that run on after the call may have a copy of the work.
template <class Work>
void run_workers(int workers, const Work& work) {
    answer::run_workers(workers, std::function<void(int)>{work});
}

}  // namespace rt
