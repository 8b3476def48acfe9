#pragma once
#include <companion/model/exercise.hpp>

namespace companion {

// The hints of an exercise, from its chapter's file of hints: the ordered list below the heading
// "## NN.k". None if the file or the heading is missing.
std::vector<std::string> hints(const Course& course, const Exercise& exercise);
// The same of a chapter's graft, below the heading "## graft".
std::vector<std::string> hints_of_graft(const Course& course, const Chapter& chapter);

// A hint in two parts: one for the core, and one for the stars, which starts at the first paragraph
// that begins with ★. Either part may be empty.
struct HintParts {
    std::string core, star;
};
HintParts parts_of(const std::string& hint);

// The hints of an exercise without what is for its stars, until its core passes.
std::vector<std::string> hints_in_view(const Course& course, const Exercise& exercise);

// Counts a hint of the exercise or graft with this ID, and returns the number of the one that is
// due, from 0 on; `most` if there are no more.
int due_hint(const Course& course, const std::string& id, std::size_t most);

// A hint without Markdown's code marks.
std::string plain_hint(std::string hint);

}  // namespace companion
