#pragma once
#include <functional>

namespace answer {

void run_workers(int workers, const std::function<void(int)>& work);

}  // namespace answer

namespace rt {

using answer::run_workers;

// The work is copied: in a wrong answer, threads that run on after the call may still need it.
template <class Work>
void run_workers(int workers, const Work& work) {
    answer::run_workers(workers, std::function<void(int)>{work});
}

}  // namespace rt
