#pragma once
// How often an answer chose each cell of a table, beside how often that was expected: two small
// pictures. A checkpoint writes both numbers for each cell: see pictured() in
// tests/support/pictured.hpp.

#include <companion/check/test_results.hpp>
#include <companion/model/exercise.hpp>
#include <map>
#include <optional>
#include <rt/image.hpp>

namespace companion {

// Cells in rows, from the top down.
struct Counts {
    std::size_t columns = 1;
    std::vector<double> seen{}, expected{};  // of the same size, a multiple of columns
};

// What stands in a message: "2;3 5;4 4" for two cells in one row, of which the first was chosen 3
// times and expected 4 times. None if it is anything else.
std::optional<Counts> read_counts(const std::string& text);

// How often these cells were chosen, `seen` or `expected`: bars if there is one row, else shades.
// Full height or brightness is 1.5 times the largest number that is expected.
rt::Image picture_of(const Counts& counts, const std::vector<double>& numbers);

// Keeps the counts of a failing test case of the core as out/counts_expected.png and
// out/counts_yours.png, and returns a sentence about them: of the one with the name `telling`, or
// else of the first that has counts. If none has, it removes the pictures of an earlier check and
// returns nothing.
std::string keep_counts(const Course& course, std::vector<TestCase> tests,
                        const std::string& telling);
void forget_counts(const Course& course);

// The PNG files that are kept, by the names "counts_expected" and "counts_yours"; both or none.
std::map<std::string, std::string> kept_counts(const Course& course);

}  // namespace companion
