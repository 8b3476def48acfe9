#pragma once
// The exercises: what course.json says about them, and how far the learner's files are.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

struct Exercise {
    std::string id;                // "01.3"
    std::string title;             // "Length and unit vectors"
    int minutes = 0;               // for the core; 0: the whole exercise is a star
    int star_minutes = 0;          // beyond that
    bool several_answers = false;  // right ones that draw different pictures
    Chapter chapter;
    std::vector<fs::path>
        files;              // that the learner writes, such as exercises/01_vectors/rt/dot.hpp
    int shipped_todos = 0;  // in these files, for this exercise
    int functions = 0;      // that the learner writes: those with an rt::todo
    // Of these files as they were shipped; empty if nobody knows, or if they also hold another
    // exercise.
    std::string shipped_hash{};
    std::vector<fs::path> chapter_files{};  // of all exercises of its chapter

    bool is_star() const { return minutes == 0; }
    // "exercises/00_toolchain/rt/a.hpp, exercises/..."
    std::string file_list() const;
    // "docs/01-vectors.md, section 01.3"
    std::string section() const { return chapter.text.string() + ", section " + id; }
};

// The exercises of a chapter in their order.
std::vector<Exercise> exercises(const Course& course, const Chapter& chapter);

// The exercises of all chapters, or of some.
std::vector<Exercise> exercises(const Course& course);
std::vector<Exercise> exercises(const Course& course, const std::vector<Chapter>& some);

// The exercise "NN.k", or the one to which a file belongs: relative to the course's folder, or with
// its full path. Throws app::UsageError, which lists the exercises.
Exercise find_exercise(const Course& course, const std::string& id);

// What the learner has written for an exercise: a hash over its files as they are now, and over
// those that the learner has added to the chapter's folder, where the compiler finds them.
std::string hash_of(const Course& course, const Exercise& exercise);

// What is wrong with its files, in one line, if one is missing, a folder or a pipe:
// "exercises/... is missing; ..."; otherwise empty. If a file of the learner's were missing, the
// compiler would find the solution's.
std::string trouble_with_files(const Course& course, const Exercise& exercise);

// Whether the learner has begun it: an rt::todo is gone, or a file that it has
// alone is not as it was shipped.
bool is_begun(const Course& course, const Exercise& exercise);

// Those of its functions that still have an rt::todo, by name.
std::vector<std::string> functions_left(const Course& course, const Exercise& exercise);

// How many calls of rt::todo for this exercise are left in its files.
int todos_left(const Course& course, const Exercise& exercise);

}  // namespace companion
