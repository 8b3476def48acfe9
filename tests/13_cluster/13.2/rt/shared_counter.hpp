#pragma once
#include <rt/ranks.hpp>

namespace answer {

MPI_Win open_counter(MPI_Comm ranks);
int count_up(MPI_Win window, int n);

}  // namespace answer

namespace rt {

using answer::count_up;
using answer::open_counter;

}  // namespace rt
