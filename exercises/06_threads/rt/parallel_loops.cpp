#include <rt/parallel_loops.hpp>
#include <rt/todo.hpp>
#ifdef RT_HAS_OPENMP
#include <omp.h>
#endif
#ifdef RT_HAS_TBB
#include <algorithm>
#include <execution>
#endif

namespace rt {

// The code between #ifdef and #endif is compiled only if the library is available.
// parallel_loops.hpp says what the two functions do.
// Star: an exception in a job reaches the caller. parallel_jobs.hpp catches it, and throws it again
// after your loop.

#ifdef RT_HAS_OPENMP
// Exercise 06.5. A plain loop over the jobs, and above it one line that makes OpenMP divide the
// jobs among threads: a parallel for with a dynamic schedule and num_threads(workers).
// omp_get_thread_num() is the number of the thread that calls it.
void loop_with_openmp(int jobs, int workers, const std::function<void(int, int)>& work) {
    rt::todo("06.5", jobs, workers, work);
}
#endif

#ifdef RT_HAS_TBB
// Exercise 06.5. One line: std::for_each over the jobs, with std::execution::par as its first
// argument.
void loop_with_standard_algorithm(std::span<const int> jobs, const std::function<void(int)>& work) {
    rt::todo("06.5", jobs, work);
}
#endif

}  // namespace rt
