#pragma once
// The other way to choose an entry of a table, for the study: without any search.

#include <algorithm>
#include <cstddef>
#include <rt/real.hpp>
#include <vector>

namespace light {

// Each entry has a cell of the same size. A light entry fills only a part of its cell, and a heavy
// one lends the rest: its alias. Source: Walker, "An efficient method for generating discrete
// random variables with general distributions", ACM TOMS 3(3), 1977; filled as by Vose, 1991.
class AliasTable {
  public:
    // At least one weight, and the sum is greater than 0.
    explicit AliasTable(const std::vector<rt::Real>& weights) : cells_(weights.size()) {
        double sum = 0;
        for (const rt::Real weight : weights) sum += static_cast<double>(weight);
        std::vector<double> fill;
        std::vector<std::size_t> light, heavy;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            fill.push_back(static_cast<double>(weights[i]) / sum *
                           static_cast<double>(weights.size()));
            (fill[i] < 1 ? light : heavy).push_back(i);
        }
        while (!light.empty() && !heavy.empty()) {
            const std::size_t from = heavy.back(), to = light.back();
            light.pop_back();
            cells_[to] = {static_cast<rt::Real>(fill[to]), from};
            fill[from] -= 1 - fill[to];
            if (fill[from] >= 1) continue;
            heavy.pop_back();
            light.push_back(from);
        }
        for (const std::vector<std::size_t>& rest : {light, heavy})
            for (const std::size_t i : rest) cells_[i] = {1, i};
    }

    // The entry for a random number, 0 <= number < 1.
    std::size_t pick(rt::Real number) const {
        const rt::Real place = number * static_cast<rt::Real>(cells_.size());
        const std::size_t cell = std::min(static_cast<std::size_t>(place), cells_.size() - 1);
        return place - static_cast<rt::Real>(cell) < cells_[cell].own ? cell : cells_[cell].alias;
    }

  private:
    struct Cell {
        rt::Real own = 1;  // the share of the cell that is its own entry's
        std::size_t alias = 0;
    };
    std::vector<Cell> cells_;
};

}  // namespace light
