#pragma once
// Whose code runs in the programs that draw and measure with the learner's code: the learner's
// files for every exercise that passes, and the solution's for the others. If the learner asks for
// it, the learner's files are also used for exercises that fail.

#include <companion/model/exercise.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace companion {

struct Yours {
    std::vector<std::string> passing, others;  // exercises "NN.k" in their order
    std::vector<fs::path> files;               // to use, such as exercises/01_vectors/rt/dot.hpp

    // The passing exercises whose picture may still differ from the solution's, with the reason:
    // "03.1", "its stars are open".
    std::map<std::string, std::string> may_differ = {};

    // Exercises that are begun or fail although the learner's code runs; exercises that are not
    // begun, in the same files; and those that are begun or fail, and for which the solution stands
    // in.
    std::vector<std::string> failing = {}, unwritten = {}, replaced = {};

    // "Yours: 01, 02, 03.1. The solution's: 03.2 to 03.3. It stands in for 03.2, which does not
    // pass yet." A chapter's number stands for all of its exercises. Or "All of the code is yours.
    // These do not pass yet, but are used anyway: 03.1."
    std::string words() const;
    // The same for a picture's caption, which other people read: "Drawn by its author's code for
    // 01, 02, 03.1 to 03.2, and by the course's for 03.3."
    std::string caption() const;
};

// The text of a file of the learner's or of a solution's, such as exercises/01_vectors/rt/dot.hpp,
// for a copy of it: compiler messages name the file itself.
std::string text_with_origin(const Course& course, const fs::path& file);

// Checks the exercises up to this chapter that have changed since their last check.
void check_what_changed(const Course& course, const Chapter& last);

// Checks the exercises up to this chapter that have changed since their last check, and fills
// build/yours/rt with the files to use. Throws app::Failure if they cannot be written.
Yours put_yours_in_place(const Course& course, const Chapter& last);
// The same, but with the solution's code for the exercises with these IDs.
Yours put_yours_in_place_except(const Course& course, const Chapter& last,
                                const std::set<std::string>& some);
// The same, but also with the learner's code for exercises that are begun or fail.
Yours put_all_yours_in_place(const Course& course, const Chapter& last);

}  // namespace companion
