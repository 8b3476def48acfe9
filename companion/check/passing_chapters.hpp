#pragma once
// Which chapters' exercises the learner has solved.

#include <companion/check/check.hpp>

namespace companion {

struct CheckedChapter {
    Chapter chapter;
    std::vector<Checked> exercises;

    bool passes() const;
    // "yours: 7 exercises pass", or why the solution's code is used: "01.3 fails", "02.1 to 02.4
    // are still to be written".
    std::string why() const;
};

// Checks all exercises of the core.
std::vector<CheckedChapter> check_all_chapters(const Course& course);

}  // namespace companion
