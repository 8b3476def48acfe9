#pragma once
// The group of ranks: how a run joins it, whether all ranks are alike, and how rank 0 sends bytes
// to all ranks.

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <app/errors.hpp>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <rt/hash_of.hpp>
#include <rt/ranks.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace cluster {

// Whether mpirun or srun has started this run as a rank. If not, the run draws alone, without MPI.
inline bool has_group() {
    const auto is_set = [](const char* name) { return std::getenv(name) != nullptr; };
    return is_set("OMPI_COMM_WORLD_SIZE") || is_set("PMIX_RANK") || is_set("PMI_RANK");
}

// Open MPI 4 has several kinds of windows. On more than one machine, windows that use RDMA fail
// over TCP ("invalid window", issue 11466 of Open MPI), and windows that use UCX end late. The two
// kinds chosen here work everywhere. If OMPI_MCA_osc is already set, it stays as it is.
inline void choose_kind_of_window() {
#if defined(OMPI_MAJOR_VERSION) && OMPI_MAJOR_VERSION < 5
    ::setenv("OMPI_MCA_osc", "sm,pt2pt", 0);
#endif
}

// A run is in the group as long as its Membership exists. Only the thread that creates the
// Membership may call MPI.
class Membership {
  public:
    Membership(int& argc, char**& argv) {
        choose_kind_of_window();
        int provided = 0;
        MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    }
    ~Membership() { MPI_Finalize(); }
    Membership(const Membership&) = delete;
    Membership& operator=(const Membership&) = delete;
};

// Whether this rank's stderr, which mpirun passes on, ends up in a terminal. (On the machine where
// mpirun itself runs, mpirun is the rank's parent process.)
inline bool mpirun_has_terminal() {
    const std::string errors = "/proc/" + std::to_string(::getppid()) + "/fd/2";
    const int file = ::open(errors.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK);
    const bool is_terminal = ::isatty(file) != 0;
    if (file >= 0) ::close(file);
    return is_terminal;
}

// The largest number that a message can have as its tag: 32,767 or more.
inline int largest_tag() {
    int* largest = nullptr;
    int is_known = 0;
    MPI_Comm_get_attr(MPI_COMM_WORLD, MPI_TAG_UB, &largest, &is_known);
    return is_known ? *largest : 32'767;
}

// A hash of the program's file: it differs between compilers and between precisions.
inline std::uint64_t hash_of_program() {
    std::ifstream in{"/proc/self/exe", std::ios::binary};
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return rt::hash_of(bytes.str());
}

// The ranks of the group, as rank 0 knows them.
struct Ranks {
    bool are_alike = false;
    std::vector<std::string> names = {};  // such as "rank 2 on node7"
};

// All ranks must call this function. If a rank runs another program than rank 0, was started with
// other options, or has an MPI that does not allow threads, the function throws app::Failure on
// rank 0, and the ranks are not alike on the other ranks.
inline Ranks meet_ranks(int argc, char** argv) {
    constexpr int host_size = MPI_MAX_PROCESSOR_NAME;
    struct Introduction {
        std::uint64_t program, options;
        int threads;  // what its MPI allows
        std::array<char, host_size> host;
    } mine{};
    std::string options;
    for (int i = 1; i < argc; ++i) options += std::string{argv[i]} + '\n';
    mine.program = hash_of_program();
    mine.options = rt::hash_of(options);
    int length = 0;
    MPI_Get_processor_name(mine.host.data(), &length);

    MPI_Query_thread(&mine.threads);

    const bool is_first = rt::rank_of(MPI_COMM_WORLD) == 0;
    std::vector<Introduction> all(static_cast<std::size_t>(rt::rank_count(MPI_COMM_WORLD)));
    MPI_Gather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, 0, MPI_COMM_WORLD);
    Ranks ranks;
    std::string wrong;
    for (std::size_t rank = 0; rank < all.size() && is_first && wrong.empty(); ++rank) {
        const std::string name = "rank " + std::to_string(rank) + " on " + all[rank].host.data();
        ranks.names.push_back(name);
        if (all[rank].program != mine.program)
            wrong = name + " runs another program than rank 0; start the same file everywhere";
        else if (all[rank].options != mine.options)
            wrong = name + " was started with other options than rank 0; give all the same";
        else if (all[rank].threads < MPI_THREAD_FUNNELED)
            wrong = name + " has an MPI that does not allow a program to have threads";
    }
    int is_alike = wrong.empty();
    MPI_Bcast(&is_alike, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (!wrong.empty()) throw app::Failure(wrong);
    ranks.are_alike = is_alike != 0;
    return ranks;
}

// All ranks must call this function. On each rank, returns the bytes that rank 0 has passed in.
inline std::string broadcast(std::string bytes) {
    std::uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    bytes.resize(size);
    constexpr std::uint64_t most = 1 << 30;  // a count is an int
    for (std::uint64_t at = 0; at < size; at += most)
        MPI_Bcast(&bytes[at], static_cast<int>(std::min(most, size - at)), MPI_BYTE, 0,
                  MPI_COMM_WORLD);
    return bytes;
}

}  // namespace cluster
