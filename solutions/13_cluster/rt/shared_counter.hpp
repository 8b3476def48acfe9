#pragma once
#include <rt/ranks.hpp>

namespace rt {

// Creates a window in the memory of rank 0 that holds a number and is open to all ranks. All ranks
// call it together. The number is 0 before any rank gets the window.
// Star: several windows at a time count separately.
inline MPI_Win open_counter(MPI_Comm ranks) {
    const bool is_here = rank_of(ranks) == 0;
    int* number = nullptr;
    MPI_Win window{};
    MPI_Win_allocate(is_here ? sizeof(int) : 0, sizeof(int), MPI_INFO_NULL, ranks, &number,
                     &window);
    if (is_here) *number = 0;
    MPI_Barrier(ranks);  // no rank counts before the number is 0
    MPI_Win_lock_all(0, window);
    return window;
}

// Adds n to the number in the window, and returns what it was before, in a single step. Any rank
// may call it at any time, whatever the others are doing.
inline int count_up(MPI_Win window, int n) {
    int before = 0;
    MPI_Fetch_and_op(&n, &before, MPI_INT, 0, 0, MPI_SUM, window);
    MPI_Win_flush(0, window);  // until it returns, `before` may not have arrived
    return before;
}

}  // namespace rt
