#pragma once
// What the fuzzers' targets share. A promise that is broken ends the program, which libFuzzer
// reports.

#include <cstddef>
#include <cstdlib>
#include <rt/color.hpp>

namespace fuzzing {

inline void must(bool holds) {
    if (!holds) std::abort();
}

template <class Table>
bool is_index_of(const Table& table, int index) {
    return 0 <= index && static_cast<std::size_t>(index) < table.size();
}

// The samples of side x side pixels have colors that light may have.
template <class Renderer>
void draw(const Renderer& renderer, int side) {
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const rt::Color color = renderer(x, y);
            must(is_finite(color) && color.r >= 0 && color.g >= 0 && color.b >= 0);
        }
}

}  // namespace fuzzing
