#include <cstdlib>
#include <new>
#include <rt/compiler.hpp>
#include <rt/gather_rows.hpp>
#include <rt/slice_rows.hpp>

#include "on_ranks.hpp"

using namespace checkpoint;
using rt::Color;

namespace {

// What is sent and how much memory is asked for, while an answer is watched: then nothing is sent,
// and nobody gets more than 4 gigabytes.
bool is_watched = false;
int gathers = 0;  // how often this rank called MPI_Gatherv
int sent_count = 0;
std::int64_t sent_bytes = 0;
std::size_t most_memory = 0;

int count_sent(int count, MPI_Datatype type) {
    int size = 0;
    MPI_Type_size(type, &size);
    sent_count = count;
    sent_bytes += std::int64_t{count} * size;
    return MPI_SUCCESS;
}

Color color_of(int x, int y) {
    return {static_cast<Real>(x), static_cast<Real>(y), real(0.5)};
}

// Gathers a picture whose colors are their places.
std::string gather(int width, int height, MPI_Comm ranks) {
    const auto [begin, end] = rt::slice_rows(height, rt::rank_count(ranks), rt::rank_of(ranks));
    std::vector<Color> mine;
    for (int y = begin; y < end; ++y)
        for (int x = 0; x < width; ++x) mine.push_back(color_of(x, y));
    const std::vector<Color> all = rt::gather_rows(mine, width, height, ranks);

    const std::string picture =
        "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
    const std::size_t expected =
        rt::rank_of(ranks) == 0 ? static_cast<std::size_t>(width * height) : 0;
    if (all.size() != expected)
        return picture + ": expected " + std::to_string(expected) + " pixels, actual " +
               std::to_string(all.size()) +
               "\nHint: rank 0 gets the whole picture, and the other ranks get an empty vector";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        if (all[i] == color_of(x, y)) continue;
        return picture + ", pixel (" + std::to_string(x) + ", " + std::to_string(y) +
               "): expected the color with red " + text(color_of(x, y).r) + " and green " +
               text(color_of(x, y).g) + ", actual " + text(all[i].r) + " and " + text(all[i].g) +
               "\nHint: count k is the number of pixels that rank k sends, and displacement k is "
               "the number of pixels before them in the picture";
    }
    return {};
}

}  // namespace

// These take the place of MPI's functions, which have other names as well.
int MPI_Gatherv(const void* send, int count, MPI_Datatype type, void* receive, const int counts[],
                const int begins[], MPI_Datatype received, int root, MPI_Comm ranks) {
    ++gathers;
    if (is_watched) return count_sent(count, type);
    return PMPI_Gatherv(send, count, type, receive, counts, begins, received, root, ranks);
}
int MPI_Igatherv(const void* send, int count, MPI_Datatype type, void* receive, const int counts[],
                 const int begins[], MPI_Datatype received, int root, MPI_Comm ranks,
                 MPI_Request* request) {
    ++gathers;
    if (!is_watched)
        return PMPI_Igatherv(send, count, type, receive, counts, begins, received, root, ranks,
                             request);
    *request = MPI_REQUEST_NULL;
    return count_sent(count, type);
}
int MPI_Send(const void* send, int count, MPI_Datatype type, int to, int tag, MPI_Comm ranks) {
    if (is_watched) return count_sent(count, type);
    return PMPI_Send(send, count, type, to, tag, ranks);
}
int MPI_Isend(const void* send, int count, MPI_Datatype type, int to, int tag, MPI_Comm ranks,
              MPI_Request* request) {
    if (!is_watched) return PMPI_Isend(send, count, type, to, tag, ranks, request);
    *request = MPI_REQUEST_NULL;
    return count_sent(count, type);
}

RT_NOT_INLINED void* operator new(std::size_t size) {
    if (is_watched) most_memory = std::max(most_memory, size);
    const bool is_refused = is_watched && size > std::size_t{1} << 32;
    if (void* const block = is_refused ? nullptr : std::malloc(size ? size : 1)) return block;
    throw std::bad_alloc{};
}
RT_NOT_INLINED void operator delete(void* block) noexcept {
    std::free(block);
}
RT_NOT_INLINED void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}

TEST_CASE("13.1 the rows of all ranks arrive in the right order", "[13.1]") {
    for (const int count : {1, 2, 3, 4})
        on_ranks(count, [](MPI_Comm ranks) {
            for (const auto& [width, height] :
                 {std::pair{3, 12}, {5, 10}, {16, 9}, {1, 7}, {40, 31}, {1, 70'000}})
                if (const std::string wrong = gather(width, height, ranks); !wrong.empty())
                    return wrong;
            return std::string{};
        });
}

TEST_CASE("13.1 ranks without rows take part", "[13.1]") {
    on_ranks(4, [](MPI_Comm ranks) {
        for (const auto& [width, height] : {std::pair{6, 1}, {6, 3}, {1, 2}}) {
            gathers = 0;
            const std::string wrong = gather(width, height, ranks);
            int most = 0;
            PMPI_Allreduce(&gathers, &most, 1, MPI_INT, MPI_MAX, ranks);
            if (!wrong.empty()) return wrong;
            if (gathers != most)
                return "a picture of " + std::to_string(height) + " rows, so that " +
                       std::to_string(4 - height) +
                       " of 4 ranks have none: another rank calls MPI_Gatherv, and this one does "
                       "not\nHint: all ranks of a group must make the same collective calls, also "
                       "with a count of 0";
        }
        return std::string{};
    });
}

TEST_CASE("13.1 a picture may have more pixels than an int can count", "[13.1][hard]") {
    on_ranks(2, [](MPI_Comm ranks) {
        // Nobody looks at the pixels: there is only one.
        const Color pixel;
        constexpr int side = 1 << 17;
        const std::span<const Color> mine{&pixel, std::size_t{side} * side / 2};
        is_watched = true;
        try {
            rt::gather_rows(mine, side, side, ranks);
        } catch (const std::bad_alloc&) {
            // So much memory is refused.
        } catch (...) {
            is_watched = false;
            throw;
        }
        is_watched = false;
        if (rt::rank_of(ranks) == 0) {
            if (most_memory >= 2 * mine.size_bytes()) return std::string{};
            return "rank 0 makes a picture of 131,072 x 131,072 pixels: expected " +
                   std::to_string(2 * mine.size_bytes()) + " bytes of memory, actual " +
                   std::to_string(most_memory) +
                   "\nHint: in an int, width * height overflows: convert both to std::size_t "
                   "before you multiply";
        }
        const auto expected = static_cast<std::int64_t>(mine.size_bytes());
        if (sent_bytes == expected) return std::string{};
        return "rank 1 sends its half of a picture of 131,072 x 131,072 pixels: expected " +
               std::to_string(expected) + " bytes, actual " + std::to_string(sent_bytes) +
               ", because the count is " + std::to_string(sent_count) +
               "\nHint: MPI's counts are int. What could you count instead of pixels, with a type "
               "of your own (MPI_Type_contiguous)?";
    });
}
