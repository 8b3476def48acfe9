#include <atomic>
#include <exception>
#include <mutex>
#include <rt/parallel_jobs.hpp>
#include <rt/parallel_loops.hpp>
#ifdef RT_HAS_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <numeric>
#include <vector>
#endif

namespace rt {
namespace {

// With either library, an exception that leaves a thread ends the program. This class keeps the
// first exception for the caller.
class FirstException {
  public:
    template <class Work>
    void guard(Work work) noexcept {
        if (failed_) return;
        try {
            work();
        } catch (...) {
            const std::lock_guard lock{mutex_};
            if (!first_) first_ = std::current_exception();
            failed_ = true;
        }
    }
    void rethrow() const {
        if (first_) std::rethrow_exception(first_);
    }

  private:
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::exception_ptr first_;
};

#ifdef RT_HAS_TBB
void by_standard_algorithm(int jobs, int workers, const JobWork& work) {
    // The algorithm itself cannot be told how many threads to use; TBB, the library that runs it,
    // can.
    const tbb::global_control at_most{tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(workers)};
    FirstException exception;
    tbb::task_arena{workers}.execute([&] {
        std::vector<int> numbers(static_cast<std::size_t>(jobs));
        std::iota(numbers.begin(), numbers.end(), 0);
        loop_with_standard_algorithm(numbers, [&](int job) {
            exception.guard([&] { work(job, tbb::this_task_arena::current_thread_index()); });
        });
    });
    exception.rethrow();
}
#endif

#ifdef RT_HAS_OPENMP
void by_openmp(int jobs, int workers, const JobWork& work) {
    FirstException exception;
    loop_with_openmp(jobs, workers,
                     [&](int job, int worker) { exception.guard([&] { work(job, worker); }); });
    exception.rethrow();
}
#endif

}  // namespace

JobSpreader spread_by_standard_algorithm() {
#ifdef RT_HAS_TBB
    return by_standard_algorithm;
#else
    return nullptr;
#endif
}

JobSpreader spread_by_openmp() {
#ifdef RT_HAS_OPENMP
    return by_openmp;
#else
    return nullptr;
#endif
}

}  // namespace rt
