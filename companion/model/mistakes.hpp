#pragma once
// The known mistakes of the exercises. tests/mistakes/NN_topic/NN.k.md holds those of one exercise:
// an explanation of each for the learner, and the edits that make it from the solution.
//
//   # Mistakes of NN.k
//
//   ## NN.k_name
//   title: what is wrong, in one line
//   caught by: NN.k the test case that fails
//   changes picture: yes          (and other optional lines, see mistakes.cpp)
//
//   The explanation, for the learner.
//
//   ```diff rt/file.hpp
//    a whole line of the solution that stays, to find the place
//   -whole lines of the solution
//   +what the mistake has instead
//   @@
//   -the lines of another edit of this file
//   ```
//
// A mistake may have several edits; each edit starts from the result of the edit before it. With
// the line "edits: plain answer", the first starts from the plain answer in tests/plain: if a slip
// is in the core, the values that the checkpoints print also depend on whether the answer has the
// star.

#include <companion/model/course.hpp>
#include <map>
#include <string>
#include <vector>

namespace companion {

struct Edit {
    std::string file;           // "rt/refract.hpp"
    std::string before, after;  // whole lines
    std::string place;          // "tests/mistakes/05_metal_glass/05.3.md:37", for messages
};

struct Mistake {
    std::string name;                            // "01.3_overflows"
    std::string title;                           // in one line
    std::string caught_by;                       // the name of the test case that fails
    std::string explanation;                     // in one line, however long
    std::map<std::string, std::string> remarks;  // the optional lines: "changes picture" is "yes"
    std::vector<Edit> edits;                     // at least one
};

// The mistakes in a file. Throws app::Failure, which names file and line, if the file is not in the
// format above.
std::vector<Mistake> read_mistakes(const fs::path& file);

// All mistakes of a chapter, by exercise.
std::vector<Mistake> read_mistakes(const Course& course, const Chapter& chapter);

// A mistake by its name. Throws app::Failure if there is none.
Mistake read_mistake(const Course& course, const Chapter& chapter, const std::string& name);

// Whether code can contain this mistake, given the answer's code without comments: a mistake in
// something that the code does not use is impossible, and so is one that leaves out what it uses.
bool may_be(const Mistake& mistake, const std::string& code);

// Whether the results speak against this mistake, given the names of the test cases that failed, in
// their order, and of those that passed. They do if the test case that catches the mistake passed,
// or if the mistake is in a later step ("00.1 step 4 ...") than the first failure.
bool is_refuted(const Mistake& mistake, const std::vector<std::string>& failed,
                const std::vector<std::string>& passed);

// The files that a mistake changes, by name ("rt/refract.hpp"), made from the files in this folder.
// Throws app::Failure if the lines to replace do not occur exactly once.
std::map<std::string, std::string> edited_files(const Mistake& mistake, const fs::path& solution);

// The same, made from the chapter's solutions or plain answers.
std::map<std::string, std::string> edited_files(const Course& course, const std::string& chapter,
                                                const Mistake& mistake);

}  // namespace companion
