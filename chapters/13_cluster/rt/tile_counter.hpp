#pragma once
#include <rt/shared_counter.hpp>

namespace rt {

// A counter made of the functions of 13.2 (given). Its fetch_add works like that of a
// std::atomic<int>, so take_tile (06.3) can take tiles from it. All ranks must create the counter
// together, and destroy it together.
class TileCounter {
  public:
    explicit TileCounter(MPI_Comm ranks) : window_{open_counter(ranks)} {}
    ~TileCounter() {
        MPI_Win_unlock_all(window_);
        MPI_Win_free(&window_);
    }
    TileCounter(const TileCounter&) = delete;
    TileCounter& operator=(const TileCounter&) = delete;

    int fetch_add(int n) { return count_up(window_, n); }

  private:
    MPI_Win window_;
};

}  // namespace rt
