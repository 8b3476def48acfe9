#pragma once
#include "../types.hpp"

namespace rt {

class SharedCounter {
  public:
    explicit SharedCounter(MPI_Comm ranks) : own_{answer::make_counter(ranks)} {}
    int fetch_add(int n) { return own_->fetch_add(n); }

  private:
    std::unique_ptr<answer::Counter> own_;
};

}  // namespace rt
