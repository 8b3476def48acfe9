#pragma once
#include <rt/ranks.hpp>
#include <rt/slice_rows.hpp>
#include <span>
#include <vector>

namespace rt {

inline std::vector<Color> gather_rows(std::span<const Color> mine, int width, int height,
                                      MPI_Comm ranks) {
    std::vector<int> counts, begins;
    for (int k = 0; k < rank_count(ranks); ++k) {
        const Rows rows = slice_rows(height, rank_count(ranks), k);
        counts.push_back((rows.end - rows.begin) * width);
        begins.push_back(rows.begin * width);
    }
    std::vector<Color> all;
    if (rank_of(ranks) == 0) all.resize(static_cast<std::size_t>(width * height));
    MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), mpi_color(), all.data(), counts.data(),
                begins.data(), mpi_color(), 0, ranks);
    return all;
}

}  // namespace rt
