#pragma once
// The loops of exercise 06.5, in parallel_loops.cpp; each exists only if this build has the library
// for it.
#include <functional>
#include <span>
#include <version>

// A standard library may lack the parallel algorithms even if TBB is installed.
#if defined RT_HAS_TBB && !defined __cpp_lib_parallel_algorithm
#undef RT_HAS_TBB
#endif

namespace rt {

// Calls work(job, worker) once for each job 0 ... jobs - 1, in up to `workers` threads of OpenMP.
// `worker` is the number that OpenMP gives to the thread, 0 ... workers - 1. Whichever thread is
// free takes the next job. `work` does not throw.
void loop_with_openmp(int jobs, int workers, const std::function<void(int, int)>& work);

// Calls work(job) once for each of these jobs, with a standard algorithm that may use several
// threads. Their number is not set here. `work` does not throw.
void loop_with_standard_algorithm(std::span<const int> jobs, const std::function<void(int)>& work);

}  // namespace rt
