#pragma once
// A chapter's picture drawn by the learner's code, compared with the one that the solution draws.

#include <companion/check/yours.hpp>
#include <companion/compare/comparison.hpp>

namespace companion {

struct ComparedPicture {
    Yours yours;  // whose code drew it
    Comparison found;
    // Why it differs although all code that runs is right, line by line; empty if there is no such
    // reason.
    std::vector<std::string> excused;

    bool is_right() const { return found.same || !excused.empty(); }
};

// Builds both programs and compares what they draw. Throws DrawingFailed.
ComparedPicture compare_picture(const Course& course, const Chapter& chapter);

}  // namespace companion
