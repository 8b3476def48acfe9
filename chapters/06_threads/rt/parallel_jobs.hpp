#pragma once
#include <functional>

namespace rt {

// Work that is called once for each job, with the job's number, 0 ... jobs - 1, and the worker's
// number, 0 ... workers - 1. No two calls with the same worker overlap in time.
using JobWork = std::function<void(int job, int worker)>;
using JobSpreader = void (*)(int jobs, int workers, const JobWork& work);

// The loops of 06.5, as functions that spread jobs over workers (given). Each is null if this build
// does not have the library for it. The first exception of a job reaches the caller, and no further
// jobs begin after it.
JobSpreader spread_by_standard_algorithm();  // std::for_each(std::execution::par, ...), with TBB
JobSpreader spread_by_openmp();              // `#pragma omp parallel for`

}  // namespace rt
