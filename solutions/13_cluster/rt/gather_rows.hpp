#pragma once
#include <rt/ranks.hpp>
#include <rt/slice_rows.hpp>
#include <span>
#include <vector>

namespace rt {

// Collects a picture of width x height pixels at rank 0. All ranks call it, each with the pixels of
// the rows that slice_rows gives it, row by row. Returns the whole picture on rank 0, and an empty
// vector on the other ranks. The picture may have more pixels than an int can count.
inline std::vector<Color> gather_rows(std::span<const Color> mine, int width, int height,
                                      MPI_Comm ranks) {
    const int count = rank_count(ranks), rank = rank_of(ranks);
    // MPI's counts are int. There may be too many pixels for an int, but not too many rows.
    MPI_Datatype row{};
    MPI_Type_contiguous(width, mpi_color(), &row);
    MPI_Type_commit(&row);

    std::vector<int> rows, first_row;
    for (int k = 0; k < count; ++k) {
        const auto [begin, end] = slice_rows(height, count, k);
        rows.push_back(end - begin);
        first_row.push_back(begin);
    }
    std::vector<Color> all;
    if (rank == 0) all.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    MPI_Gatherv(mine.data(), rows[static_cast<std::size_t>(rank)], row, all.data(), rows.data(),
                first_row.data(), row, 0, ranks);
    MPI_Type_free(&row);
    return all;
}

}  // namespace rt
