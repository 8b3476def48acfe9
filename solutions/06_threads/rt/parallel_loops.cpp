#include <rt/parallel_loops.hpp>
#ifdef RT_HAS_OPENMP
#include <omp.h>
#endif
#ifdef RT_HAS_TBB
#include <algorithm>
#include <execution>
#endif

namespace rt {

#ifdef RT_HAS_OPENMP
void loop_with_openmp(int jobs, int workers, const std::function<void(int, int)>& work) {
#pragma omp parallel for schedule(dynamic) num_threads(workers)
    for (int job = 0; job < jobs; ++job) work(job, omp_get_thread_num());
}
#endif

#ifdef RT_HAS_TBB
void loop_with_standard_algorithm(std::span<const int> jobs, const std::function<void(int)>& work) {
    std::for_each(std::execution::par, jobs.begin(), jobs.end(), work);
}
#endif

}  // namespace rt
