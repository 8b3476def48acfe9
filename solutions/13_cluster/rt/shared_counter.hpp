#pragma once
#include <rt/ranks.hpp>

namespace rt {

// A number in the memory of rank 0 that all ranks count up, as threads count up a std::atomic<int>.
class SharedCounter {
  public:
    // All ranks of the group make it together. It starts at 0.
    explicit SharedCounter(MPI_Comm ranks) {
        const bool is_here = rank_of(ranks) == 0;
        int* number = nullptr;
        MPI_Win_allocate(is_here ? sizeof(int) : 0, sizeof(int), MPI_INFO_NULL, ranks, &number,
                         &window_);
        if (is_here) *number = 0;
        MPI_Barrier(ranks);  // nobody counts before it is 0
        MPI_Win_lock_all(0, window_);
    }

    // All ranks give it up together (given).
    ~SharedCounter() {
        if (window_ == MPI_WIN_NULL) return;
        MPI_Win_unlock_all(window_);
        MPI_Win_free(&window_);
    }
    SharedCounter(const SharedCounter&) = delete;
    SharedCounter& operator=(const SharedCounter&) = delete;

    // Adds n, and returns what the number was before, in a single step. Any rank may call it at any
    // time, whatever the others are doing.
    int fetch_add(int n) {
        int before = 0;
        MPI_Fetch_and_op(&n, &before, MPI_INT, 0, 0, MPI_SUM, window_);
        MPI_Win_flush(0, window_);  // before that, `before` may not have arrived
        return before;
    }

  private:
    MPI_Win window_ = MPI_WIN_NULL;
};

}  // namespace rt
