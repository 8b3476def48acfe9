#pragma once
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"

namespace checkpoint {

// For INFO, before an assertion on chi_square: what was counted in each cell, and what is expected
// there. The companion shows both as small pictures, in rows of `columns` cells from the top down;
// a single row becomes bars. Cells beyond the last whole row are left out.
inline std::string pictured(const std::vector<long>& seen, const std::vector<double>& wanted,
                            std::size_t columns) {
    std::ostringstream text;
    text << counts_mark << columns;
    const std::size_t cells = seen.size() / columns * columns;
    const auto add = [&](char start, const auto& numbers) {
        for (std::size_t i = 0; i < cells; ++i) text << (i == 0 ? start : ' ') << numbers[i];
    };
    add(';', seen);
    add(';', wanted);
    return text.str();
}

}  // namespace checkpoint
