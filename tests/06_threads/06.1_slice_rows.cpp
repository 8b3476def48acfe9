#include <limits>
#include <rt/rng.hpp>
#include <rt/slice_rows.hpp>
#include <string>

#include "checkpoint.hpp"

using rt::Rows, rt::slice_rows;

namespace {

std::string text(Rows rows) {
    return "rows " + std::to_string(rows.begin) + " to " + std::to_string(rows.end);
}

constexpr const char* wide_product =
    "Hint: height * worker may need more than the 32 bits of an int, and more than the 53 bits of "
    "a double; 64 bits are enough";

// The first thing that is wrong with the slices of all workers; empty if nothing is.
std::string complaint(int height, int workers) {
    int next = 0, most = 0, least = height;
    const std::string all =
        std::to_string(height) + " rows for " + std::to_string(workers) + " workers: worker ";
    for (int worker = 0; worker < workers; ++worker) {
        const Rows rows = slice_rows(height, workers, worker);
        const std::string which = all + std::to_string(worker) + " has " + text(rows);
        if (rows.end < rows.begin) return which + ", which ends before it begins";
        least = std::min(least, rows.end - rows.begin);
        if (rows.begin == rows.end) continue;  // an empty slice may be anywhere
        if (rows.begin < next)
            return which + ", but the rows before " + std::to_string(next) +
                   " are taken (a slice ends before its row `end`)";
        if (rows.begin > next) return which + ", but no worker has row " + std::to_string(next);
        if (rows.end > height) return which + ", which is below the picture";
        next = rows.end;
        most = std::max(most, rows.end - rows.begin);
    }
    if (next != height)
        return all + std::to_string(workers - 1) + ", the last one, ends at row " +
               std::to_string(next) + ": the rest belongs to no worker";
    if (most - least > 1)
        return all.substr(0, all.size() - 7) + "the longest slice has " + std::to_string(most) +
               " rows and the shortest " + std::to_string(least);
    return {};
}

// What is wrong with the slice of one worker, where there are too many workers to ask them
// all; empty if nothing seems wrong. The workers before and after it have as many rows, or
// one more or fewer.
std::string complaint_of_one(std::int64_t height, std::int64_t workers, std::int64_t worker) {
    const auto slice = [&](std::int64_t k) {
        return slice_rows(static_cast<int>(height), static_cast<int>(workers), static_cast<int>(k));
    };
    // In any order: nothing may be remembered from one call to the next.
    const Rows after = worker + 1 < workers ? slice(worker + 1) : Rows{};
    const Rows rows = slice(worker), again = slice(worker);
    const std::string which = std::to_string(height) + " rows for " + std::to_string(workers) +
                              " workers: worker " + std::to_string(worker) + " has " + text(rows);
    if (!(again == rows)) return which + ", but on a second call " + text(again);
    const std::int64_t count = std::int64_t{rows.end} - rows.begin;
    const std::int64_t least = height / workers, most = least + (height % workers != 0);
    if (count < least || count > most)
        return which + ", a count of " + std::to_string(count) + "; expected " +
               std::to_string(least) + (most > least ? ", or one more" : "");
    if (count == 0) return {};
    const std::int64_t behind = workers - 1 - worker;
    if (rows.begin < worker * least || rows.begin > worker * most)
        return which + ", which leaves too few rows or too many for the workers before it";
    if (height - rows.end < behind * least || height - rows.end > behind * most)
        return which + ", which leaves too few rows or too many for the workers after it";
    if (after.begin < after.end && after.begin != rows.end)
        return which + ", and the next worker has " + text(after);
    return {};
}

}  // namespace

TEST_CASE("06.1 every row has one worker and slices differ by at most one row", "[06.1]") {
    for (const int height : {64, 100, 270, 271, 540, 1079})
        for (int workers = 1; workers <= 64; ++workers) REQUIRE(complaint(height, workers) == "");
}

TEST_CASE("06.1 one worker has all rows", "[06.1]") {
    for (const int height : {1, 2, 540}) {
        INFO(height << " rows, one worker: " << text(slice_rows(height, 1, 0)));
        CHECK(slice_rows(height, 1, 0) == Rows{0, height});
    }
}

TEST_CASE("06.1 equal slices have the same number of rows", "[06.1]") {
    for (int worker = 0; worker < 4; ++worker) {
        const Rows rows = slice_rows(12, 4, worker);
        INFO("12 rows for 4 workers: worker " << worker << " has " << text(rows)
                                              << ". Hint: end is the row after the last one");
        CHECK(rows == Rows{3 * worker, 3 * worker + 3});
    }
}

TEST_CASE("06.1 every row has one worker even if there are more workers than rows", "[06.1]") {
    for (int height = 0; height < 64; ++height)
        for (int workers = 1; workers <= 64; ++workers) REQUIRE(complaint(height, workers) == "");
}

TEST_CASE("06.1 no row is lost in a picture of any height", "[06.1][hard]") {
    constexpr int largest = std::numeric_limits<int>::max();
    for (const int height : {65'536, 100'000'000, largest})
        for (const int workers : {1, 2, 3, 7, 63, 64, 1000}) {
            // First a picture of few rows, in which as many are left over.
            REQUIRE(complaint(10 * workers + height % workers, workers) == "");
            INFO(wide_product);
            REQUIRE(complaint(height, workers) == "");
        }
    rt::Rng rng{6, 1};
    const auto any_below = [&](std::int64_t end) {
        return static_cast<std::int64_t>((std::uint64_t{rng()} << 31 | rng() >> 1) %
                                         static_cast<std::uint64_t>(end));
    };
    for (int i = 0; i < 3000; ++i) {
        // Numbers of any size: those of 3 digits are as frequent as those of 9. In half of the
        // rounds it is the last worker or the first.
        const auto any_size = [&] { return any_below((std::int64_t{largest} >> rng() % 31) + 1); };
        const std::int64_t height = i % 16 == 0 ? largest : any_size();
        const std::int64_t workers = i % 16 == 1   ? largest
                                     : i % 16 == 2 ? height + 1
                                                   : 1 + any_size();
        if (workers > largest) continue;
        const std::int64_t worker = i % 4 == 0 ? workers - 1 : i % 4 == 1 ? 0 : any_below(workers);
        INFO(wide_product);
        REQUIRE(complaint_of_one(height, workers, worker) == "");
    }
}
