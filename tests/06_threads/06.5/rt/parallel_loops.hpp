#pragma once
#include <functional>
#include <span>
#include <version>

// As in the header that is given.
#if defined RT_HAS_TBB && !defined __cpp_lib_parallel_algorithm
#undef RT_HAS_TBB
#endif

namespace answer {

void loop_with_openmp(int jobs, int workers, const std::function<void(int, int)>& work);
void loop_with_standard_algorithm(std::span<const int> jobs, const std::function<void(int)>& work);

}  // namespace answer

namespace rt {

using answer::loop_with_openmp;
using answer::loop_with_standard_algorithm;

}  // namespace rt
