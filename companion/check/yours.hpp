#pragma once
// Whose code runs in the programs that draw and measure with the learner's code: the learner's
// files for every exercise that passes, and the solution's for the others. Or, where a person asks
// for that, the learner's for those that fail, too.

#include <companion/model/exercise.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace companion {

struct Yours {
    std::vector<std::string> passing, others;  // exercises "NN.k" in their order
    std::vector<fs::path> files;               // to use, such as exercises/01_vectors/rt/dot.hpp

    // Those that pass, and whose picture may be another all the same, with the reason: "03.1", "its
    // stars are open".
    std::map<std::string, std::string> may_differ = {};

    // Begun or wrong, but the learner's code runs all the same; and what is not begun in the same
    // files.
    std::vector<std::string> failing = {}, unwritten = {};

    // "Yours: 01, 02, 03.1 to 03.2. The solution's: 03.3." A chapter's number means all of it. Or
    // "All of the code is yours. These do not pass yet, but are used anyway: 03.1."
    std::string words() const;
    // The same of a picture, for others: "Drawn by its author's code for 01, 02, 03.1 to 03.2, and
    // by the course's for 03.3."
    std::string caption() const;
};

// Checks what has changed since it was last checked, up to this chapter, and fills build/yours/rt
// with the files to use. Throws app::Failure if they cannot be written.
Yours put_yours_in_place(const Course& course, const Chapter& last);
// The same, but with the solution's code for some exercises, by their ids.
Yours put_yours_in_place_except(const Course& course, const Chapter& last,
                                const std::set<std::string>& some);
// The same, but with the learner's code of exercises that are begun or fail, too.
Yours put_all_yours_in_place(const Course& course, const Chapter& last);

}  // namespace companion
