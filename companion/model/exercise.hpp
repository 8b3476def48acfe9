#pragma once
// The exercises: what course.json says about them, and how far the learner has come in each.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

struct Exercise {
    std::string id;                // "01.3"
    std::string title;             // "Length and unit vectors"
    int minutes = 0;               // for the core; 0: the whole exercise is a star
    int star_minutes = 0;          // for its stars, in addition
    bool several_answers = false;  // different right answers draw different pictures
    Chapter chapter;
    std::vector<fs::path>
        files;              // that the learner writes, such as exercises/01_vectors/rt/dot.hpp
    int shipped_todos = 0;  // calls of rt::todo for this exercise in the shipped files
    int functions = 0;      // how many the learner writes: those with an rt::todo
    // A hash over these files as they were shipped; empty if they are unknown, or if one of them
    // also belongs to another exercise.
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

// The exercise whose ID, "NN.k", or one of whose files is given. The file's path may be relative to
// the course's folder or absolute. Throws app::UsageError, which lists the exercises.
Exercise find_exercise(const Course& course, const std::string& id);

// A hash over what the learner has written for an exercise: its files as they are now, and files
// that the learner has added to the chapter's folder, where the compiler finds them.
std::string hash_of(const Course& course, const Exercise& exercise);

// What is wrong with the exercise's files, in one line, if one of them is missing, a folder or a
// pipe: "exercises/... is missing; ..."; otherwise empty. If one of the learner's files were
// missing, the compiler would find the solution's file instead.
std::string trouble_with_files(const Course& course, const Exercise& exercise);

// Whether the learner has begun the exercise: an rt::todo is gone, or a file that belongs to no
// other exercise has changed since it was shipped.
bool is_begun(const Course& course, const Exercise& exercise);

// The names of the exercise's functions that still contain an rt::todo.
std::vector<std::string> functions_left(const Course& course, const Exercise& exercise);

// How many calls of rt::todo for this exercise are left in its files.
int todos_left(const Course& course, const Exercise& exercise);

}  // namespace companion
