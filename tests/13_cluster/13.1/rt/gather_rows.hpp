#pragma once
#include <rt/ranks.hpp>
#include <span>
#include <vector>

namespace answer {

std::vector<rt::Color> gather_rows(std::span<const rt::Color> mine, int width, int height,
                                   MPI_Comm ranks);

}  // namespace answer

namespace rt {

using answer::gather_rows;

}  // namespace rt
