#pragma once
#include <rt/ranks.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 13.2. A number in the memory of rank 0 that all ranks count up, as threads count up a
// std::atomic<int>. So take_tile (06.3) can take tiles from it.
class SharedCounter {
  public:
    // Exercise 13.2. All ranks of the group make it together. It starts at 0. Make window_ here,
    // and open it to all with MPI_Win_lock_all.
    explicit SharedCounter(MPI_Comm ranks) { rt::todo("13.2", ranks); }

    // All ranks give it up together (given).
    ~SharedCounter() {
        if (window_ == MPI_WIN_NULL) return;
        MPI_Win_unlock_all(window_);
        MPI_Win_free(&window_);
    }
    SharedCounter(const SharedCounter&) = delete;
    SharedCounter& operator=(const SharedCounter&) = delete;

    // Exercise 13.2. Adds n, and returns what the number was before, in a single step. Any rank may
    // call it at any time, whatever the others are doing.
    int fetch_add(int n) { return rt::todo("13.2", n); }

  private:
    MPI_Win window_ = MPI_WIN_NULL;
};

}  // namespace rt
