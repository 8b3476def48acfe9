#pragma once
// The exercises: what the texts and the stubs say of them.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

struct Exercise {
    std::string id;     // "01.3"
    std::string title;  // "Length and unit vectors"
    int minutes = 0;
    Chapter chapter;
    std::vector<fs::path>
        files;                   // that the learner writes, such as exercises/01_vectors/rt/dot.hpp
    int shipped_todos = 0;       // in these files, for this exercise
    std::string shipped_hash{};  // of these files; empty where another exercise is in them, too

    // "docs/01-vectors.md, section 01.3"
    std::string section() const { return "docs/" + chapter.document() + ", section " + id; }
};

// The exercises of a chapter in their order: one a heading "### NN.k Title (about M minutes)" of
// its text. Its files are those whose shipped stub says todo("NN.k").
std::vector<Exercise> exercises(const Course& course, const Chapter& chapter);

// The same of all chapters.
std::vector<Exercise> exercises(const Course& course);

// The exercise "NN.k". Throws app::UsageError, which says which there are.
Exercise find_exercise(const Course& course, const std::string& id);

// The hours of study that a chapter's text names: "Time: about N hours". 0 where it names none.
int hours(const Course& course, const Chapter& chapter);

// What the learner has written for an exercise: a hash over its files as they are now.
std::string hash_of(const Course& course, const Exercise& exercise);

// Whether the learner has begun it: an rt::todo is gone, or a file of it alone is not as shipped.
bool is_begun(const Course& course, const Exercise& exercise);

// How many rt::todo of this exercise are left in its files. A file that is gone counts as one.
int todos_left(const Course& course, const Exercise& exercise);

}  // namespace companion
