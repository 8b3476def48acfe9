#include <answer.hpp>
#include <rt/parallel_loops.hpp>

namespace answer EXPORTED {

#ifdef RT_HAS_OPENMP
void loop_with_openmp(int jobs, int workers, const std::function<void(int, int)>& work) {
    rt::loop_with_openmp(jobs, workers, work);
}
#endif

#ifdef RT_HAS_TBB
void loop_with_standard_algorithm(std::span<const int> jobs, const std::function<void(int)>& work) {
    rt::loop_with_standard_algorithm(jobs, work);
}
#endif

}  // namespace EXPORTED
