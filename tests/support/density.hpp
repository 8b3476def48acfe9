#pragma once
// Are two random numbers spread evenly, and independent of each other?

#include <algorithm>
#include <rt/real.hpp>

#include "statistics.hpp"

namespace checkpoint {

// Counts pairs of numbers in [0, 1) on a grid of 8 x 8 cells.
class PairCounts {
  public:
    void add(rt::Real x, rt::Real y) {
        const auto cell = [](rt::Real v) { return std::clamp(static_cast<int>(v * 8), 0, 7); };
        ++counts_[static_cast<std::size_t>(8 * cell(y) + cell(x))];
        ++pairs_;
    }
    double chi_square() const {
        return checkpoint::chi_square(counts_,
                                      std::vector<double>(64, static_cast<double>(pairs_) / 64));
    }
    // There are many of these tests, and correct code may use its random numbers in any order: it
    // exceeds this limit once in a thousand million tests.
    static double limit() {
        return 63 * std::pow(1 - 2.0 / (9 * 63) + 6 * std::sqrt(2.0 / (9 * 63)), 3);
    }

  private:
    std::vector<long> counts_ = std::vector<long>(64);
    long pairs_ = 0;
};

}  // namespace checkpoint
