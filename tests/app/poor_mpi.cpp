// Loaded before MPI (LD_PRELOAD), it makes an MPI that has few tags, 0 to 99, and, if POOR_MPI says
// so, no threads.

#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <cstdlib>

extern "C" int MPI_Comm_get_attr(MPI_Comm ranks, int key, void* value, int* is_known) {
    if (key != MPI_TAG_UB) return PMPI_Comm_get_attr(ranks, key, value, is_known);
    static int largest = 99;
    *static_cast<int**>(value) = &largest;
    *is_known = 1;
    return MPI_SUCCESS;
}

extern "C" int MPI_Query_thread(int* provided) {
    if (!std::getenv("POOR_MPI")) return PMPI_Query_thread(provided);
    *provided = MPI_THREAD_SINGLE;
    return MPI_SUCCESS;
}
