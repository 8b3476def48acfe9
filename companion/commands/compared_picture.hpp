#pragma once
// A chapter's picture as the learner's code draws it, compared with the solution's.

#include <companion/check/yours.hpp>
#include <companion/compare/comparison.hpp>

namespace companion {

struct ComparedPicture {
    Yours yours;  // whose code drew it
    Comparison found;
    // Why it differs although all that runs is right, in lines; empty if it need not be excused.
    std::vector<std::string> excused;

    bool is_right() const { return found.same || !excused.empty(); }
};

// Builds both programs and compares what they draw. Throws DrawingFailed.
ComparedPicture compare_picture(const Course& course, const Chapter& chapter);

}  // namespace companion
