#include <rt/render_tiles.hpp>
#include <rt/tile_counter.hpp>

#include "on_ranks.hpp"

using namespace checkpoint;
using rt::TileCounter;

namespace {

// What MPI allows and seldom does, it does here every time: a result arrives no sooner than it
// must, new memory holds garbage, no memory is nowhere, and a rank is slow that reads the number
// and then changes it.
struct Late {
    MPI_Win window;
    int rank;
    void* result;
    int value;
};
std::vector<std::unique_ptr<Late>> late;

int* value_that_is_late(MPI_Win window, int rank, void* result) {
    late.push_back(std::make_unique<Late>(Late{window, rank, result, 0}));
    return &late.back()->value;
}

constexpr int every_rank = -1;
void deliver(MPI_Win window, int rank) {
    yields = 0;  // this rank does not hang
    std::erase_if(late, [&](const auto& one) {
        const bool is_here = one->window == window && (one->rank == rank || rank == every_rank);
        if (is_here) *static_cast<int*>(one->result) = one->value;
        return is_here;
    });
}

// So many calls wait before they change the number.
int pauses = 0;
void pause_before_change() {
    if (--pauses >= 0) std::this_thread::sleep_for(std::chrono::milliseconds{1});
}

// For how many milliseconds rank 0 waits after it has got its next memory.
int wait_of_rank_0 = 0;

std::string differs(const std::string& what, int expected, int actual, const std::string& hint) {
    if (expected == actual) return {};
    return what + ": expected " + std::to_string(expected) + ", actual " + std::to_string(actual) +
           "\nHint: " + hint;
}

}  // namespace

int MPI_Win_allocate(MPI_Aint size, int unit, MPI_Info info, MPI_Comm ranks, void* base,
                     MPI_Win* window) {
    const int result = PMPI_Win_allocate(size, unit, info, ranks, base, window);
    auto* const bytes = *static_cast<unsigned char**>(base);
    for (MPI_Aint i = 0; i < size; ++i) bytes[i] = 90;
    if (size == 0) *static_cast<void**>(base) = nullptr;
    PMPI_Barrier(ranks);
    if (size > 0)
        std::this_thread::sleep_for(std::chrono::milliseconds{std::exchange(wait_of_rank_0, 0)});
    return result;
}

int MPI_Fetch_and_op(const void* operand, void* result, MPI_Datatype type, int rank, MPI_Aint at,
                     MPI_Op operation, MPI_Win window) {
    pause_before_change();
    return PMPI_Fetch_and_op(operand, value_that_is_late(window, rank, result), type, rank, at,
                             operation, window);
}
int MPI_Compare_and_swap(const void* to, const void* from, void* result, MPI_Datatype type,
                         int rank, MPI_Aint at, MPI_Win window) {
    pause_before_change();
    return PMPI_Compare_and_swap(to, from, value_that_is_late(window, rank, result), type, rank, at,
                                 window);
}
int MPI_Get_accumulate(const void* from, int count, MPI_Datatype type, void* result,
                       int result_count, MPI_Datatype result_type, int rank, MPI_Aint at,
                       int to_count, MPI_Datatype to_type, MPI_Op operation, MPI_Win window) {
    pause_before_change();
    return PMPI_Get_accumulate(from, count, type, value_that_is_late(window, rank, result),
                               result_count, result_type, rank, at, to_count, to_type, operation,
                               window);
}

int MPI_Put(const void* from, int count, MPI_Datatype type, int rank, MPI_Aint at, int to_count,
            MPI_Datatype to_type, MPI_Win window) {
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
    return PMPI_Put(from, count, type, rank, at, to_count, to_type, window);
}
int MPI_Accumulate(const void* from, int count, MPI_Datatype type, int rank, MPI_Aint at,
                   int to_count, MPI_Datatype to_type, MPI_Op operation, MPI_Win window) {
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
    return PMPI_Accumulate(from, count, type, rank, at, to_count, to_type, operation, window);
}

int MPI_Win_flush(int rank, MPI_Win window) {
    const int done = PMPI_Win_flush(rank, window);
    deliver(window, rank);
    return done;
}
int MPI_Win_flush_all(MPI_Win window) {
    const int done = PMPI_Win_flush_all(window);
    deliver(window, every_rank);
    return done;
}
int MPI_Win_flush_local(int rank, MPI_Win window) {
    const int done = PMPI_Win_flush_local(rank, window);
    deliver(window, rank);
    return done;
}

TEST_CASE("13.2 the counter starts at 0 and returns its value before adding", "[13.2]") {
    for (const int count : {1, 2, 4})
        on_ranks(count, [](MPI_Comm ranks) {
            TileCounter counter{ranks};
            std::string wrong;
            // In turns.
            for (int rank = 0, expected = 0; rank < rt::rank_count(ranks); ++rank) {
                if (rank == rt::rank_of(ranks))
                    for (const int n : {1, 10, 100'000}) {
                        const std::string differ =
                            differs("before " + std::to_string(n) + " is added", expected,
                                    counter.fetch_add(n),
                                    "only rank 0 has the number, it is 0 before any rank adds to "
                                    "it, and the result has arrived when MPI_Win_flush returns");
                        if (wrong.empty()) wrong = differ;
                        expected += n;
                    }
                else
                    expected += 100'011;
                MPI_Barrier(ranks);
            }
            return wrong;
        });
}

TEST_CASE("13.2 the counter is in the memory of rank 0", "[13.2]") {
    for (const int count : {1, 3})
        on_ranks(count, [](MPI_Comm ranks) {
            MPI_Win window = rt::open_counter(ranks);
            MPI_Aint* size = nullptr;
            int* number = nullptr;
            int is_known = 0;
            std::string wrong;
            MPI_Win_get_attr(window, MPI_WIN_SIZE, &size, &is_known);
            if (rt::rank_of(ranks) == 0 && *size < MPI_Aint{sizeof(int)})
                return "its part of the window: expected " + std::to_string(sizeof(int)) +
                       " bytes, actual " + std::to_string(*size) +
                       "\nHint: rank 0 asks MPI_Win_allocate for the memory of an int";
            rt::count_up(window, 5);
            MPI_Barrier(ranks);
            MPI_Win_get_attr(window, MPI_WIN_BASE, &number, &is_known);
            MPI_Win_sync(window);
            if (rt::rank_of(ranks) == 0)
                wrong = differs("each rank has added 5: the number in its memory",
                                5 * rt::rank_count(ranks), *number,
                                "MPI_Fetch_and_op adds to the number at displacement 0 of rank 0");
            MPI_Win_unlock_all(window);
            MPI_Win_free(&window);
            return wrong;
        });
}

TEST_CASE("13.2 no rank adds before the counter has been set to 0", "[13.2]") {
    on_ranks(3, [](MPI_Comm ranks) {
        wait_of_rank_0 = 50;
        TileCounter counter{ranks};
        const int before = counter.fetch_add(1);
        MPI_Barrier(ranks);
        if (0 <= before && before < 3) return std::string{};
        return "3 ranks add 1 at the same time: expected 0, 1 or 2 as the number before, actual " +
               std::to_string(before) +
               "\nHint: new memory may contain any number. Rank 0 sets it to 0, and the other "
               "ranks wait for that (MPI_Barrier)";
    });
}

TEST_CASE("13.2 every tile is taken once", "[13.2]") {
    on_ranks(4, [](MPI_Comm ranks) {
        constexpr int tiles = 3000;
        TileCounter counter{ranks};
        pauses = 20;
        std::vector<int> taken(tiles), all(tiles);
        MPI_Barrier(ranks);
        // Not for ever, as some wrong answers never say that there is none left. Whoever takes one
        // more than there are takes one of them twice.
        for (int count = 0; count <= tiles; ++count) {
            const std::optional<int> tile = rt::take_tile(counter, tiles);
            if (!tile) break;
            ++taken.at(static_cast<std::size_t>(*tile));
        }
        MPI_Reduce(taken.data(), all.data(), tiles, MPI_INT, MPI_SUM, 0, ranks);
        for (std::size_t tile = 0; tile < tiles && rt::rank_of(ranks) == 0; ++tile)
            if (const std::string wrong = differs(
                    "how many times tile " + std::to_string(tile) + " of 3000 is taken", 1,
                    all[tile],
                    "no other rank may count between reading and adding: use one call for both");
                !wrong.empty())
                return wrong;
        return std::string{};
    });
}

TEST_CASE("13.2 two counters at a time do not affect each other", "[13.2][hard]") {
    on_ranks(3, [](MPI_Comm ranks) {
        TileCounter up{ranks}, down{ranks};
        int last_up = -1, last_down = 1;
        std::string wrong;
        for (int i = 0; i < 100 && wrong.empty(); ++i) {
            const int above = up.fetch_add(2), below = down.fetch_add(-3);
            if (above <= last_up || above % 2 != 0 || above > 600 || below >= last_down ||
                below % 3 != 0 || below < -900)
                wrong =
                    "3 ranks add 2 to one counter and -3 to another: expected increasing multiples "
                    "of 2 and decreasing multiples of 3, actual " +
                    std::to_string(above) + " and " + std::to_string(below) +
                    "\nHint: each counter needs a window of its own";
            last_up = above;
            last_down = below;
        }
        MPI_Barrier(ranks);
        return wrong;
    });
}
