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

// Builds both programs and compares what they draw. With `all_yours`, the learner's code is also
// used where it fails. Throws DrawingFailed.
ComparedPicture compare_picture(const Course& course, const Chapter& chapter,
                                bool all_yours = false);

// What the comparison of these drawings says, in one sentence for `run`, which puts nothing in
// place and does not look for excuses. Empty if none of the code is the learner's.
std::string compared_in_one_line(const Course& course, const Chapter& chapter, const Yours& yours);

}  // namespace companion
