#include <limits>
#include <rt/slice_rows.hpp>
#include <string>

#include "checkpoint.hpp"

using rt::Rows, rt::slice_rows;

namespace {

std::string text(Rows rows) {
    return "rows " + std::to_string(rows.begin) + " to " + std::to_string(rows.end);
}

// What is wrong with the slices of all workers, the first thing; empty if nothing is.
std::string complaint(int height, int workers) {
    int next = 0, most = 0, least = height;
    const std::string all =
        std::to_string(height) + " rows for " + std::to_string(workers) + " workers: worker ";
    for (int worker = 0; worker < workers; ++worker) {
        const Rows rows = slice_rows(height, workers, worker);
        const std::string which = all + std::to_string(worker) + " has " + text(rows);
        if (rows.begin < next)
            return which + ", but the rows before " + std::to_string(next) +
                   " are taken (a slice ends before its row `end`)";
        if (rows.begin > next) return which + ", but nobody has row " + std::to_string(next);
        if (rows.end < rows.begin) return which + ", which ends before it begins";
        if (rows.end > height) return which + ", which is below the picture";
        next = rows.end;
        most = std::max(most, rows.end - rows.begin);
        least = std::min(least, rows.end - rows.begin);
    }
    if (next != height)
        return all + std::to_string(workers - 1) + ", the last, ends at row " +
               std::to_string(next) + ": the rest belongs to nobody";
    if (most - least > 1)
        return all.substr(0, all.size() - 7) + "the longest slice has " + std::to_string(most) +
               " rows and the shortest " + std::to_string(least);
    return {};
}

}  // namespace

TEST_CASE("06.1 every row has one worker", "[06.1]") {
    for (const int height : {64, 100, 270, 271, 540, 1079})
        for (int workers = 1; workers <= 64; ++workers) REQUIRE(complaint(height, workers) == "");
}

TEST_CASE("06.1 one worker has all rows", "[06.1]") {
    for (const int height : {1, 2, 540}) {
        INFO(height << " rows, one worker: " << text(slice_rows(height, 1, 0)));
        CHECK(slice_rows(height, 1, 0) == Rows{0, height});
    }
}

TEST_CASE("06.1 the rows of equal slices are equal in number", "[06.1]") {
    for (int worker = 0; worker < 4; ++worker) {
        const Rows rows = slice_rows(12, 4, worker);
        INFO("12 rows for 4 workers: worker " << worker << " has " << text(rows)
                                              << ". Hint: end is the row after the last one");
        CHECK(rows == Rows{3 * worker, 3 * worker + 3});
    }
}

TEST_CASE("06.1 less rows than workers", "[06.1][hard]") {
    for (int height = 0; height < 64; ++height)
        for (int workers = 1; workers <= 64; ++workers) REQUIRE(complaint(height, workers) == "");
}

TEST_CASE("06.1 no row is lost in a picture of any height", "[06.1][hard]") {
    for (const int height : {65'536, 100'000'000, std::numeric_limits<int>::max()})
        for (const int workers : {1, 2, 3, 7, 63, 64, 1000}) {
            // As many rows are left over, in a picture of few.
            REQUIRE(complaint(10 * workers + height % workers, workers) == "");
            INFO("Hint: height * worker may need more than the 32 bits of an int");
            REQUIRE(complaint(height, workers) == "");
        }
}
