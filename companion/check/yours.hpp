#pragma once
// Whose code the programs run that draw and measure with the learner's: the learner's files of
// every exercise that passes, and the solution's of the others.

#include <companion/model/exercise.hpp>
#include <string>
#include <vector>

namespace companion {

struct Yours {
    std::vector<std::string> passing, others;  // exercises "NN.k" in their order

    std::vector<fs::path> files;  // that count, such as exercises/01_vectors/rt/dot.hpp

    // "Yours: 01, 02, 03.1 to 03.2. The solution's: 03.3." A chapter's number stands for all of it.
    std::string words() const;
    // The same of a picture, for others: "Drawn by its author's code for 01, 02, 03.1 to 03.2, and
    // by the course's for 03.3."
    std::string caption() const;
};

// Checks what has changed since it was checked, up to this chapter, and fills build/yours/rt with
// the files that count. Throws app::Failure where they cannot be written.
Yours put_yours_in_place(const Course& course, const Chapter& last);

}  // namespace companion
