#pragma once
#define OMPI_SKIP_MPICXX 1  // no C++ bindings, which MPI dropped in 2012
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <rt/color.hpp>
#include <type_traits>

namespace rt {

// What the chapter's exercises share (given). The runs of the program form a group, an MPI_Comm.
// Each run is called a rank, and so is its number in the group: 0, 1, 2, ...

// The rank of this run, 0 or more.
inline int rank_of(MPI_Comm ranks) {
    int rank = 0;
    MPI_Comm_rank(ranks, &rank);
    return rank;
}

// The number of ranks, 1 or more.
inline int rank_count(MPI_Comm ranks) {
    int count = 0;
    MPI_Comm_size(ranks, &count);
    return count;
}

// MPI's type for a Color: three Reals, one after the other. With this type, every count in a call
// to MPI is a number of colors.
inline MPI_Datatype mpi_color() {
    static_assert(sizeof(Color) == 3 * sizeof(Real));
    static const MPI_Datatype type = [] {
        MPI_Datatype made{};
        MPI_Type_contiguous(3, std::is_same_v<Real, float> ? MPI_FLOAT : MPI_DOUBLE, &made);
        MPI_Type_commit(&made);
        return made;
    }();
    return type;
}

}  // namespace rt
