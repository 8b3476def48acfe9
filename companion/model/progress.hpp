#pragma once
// How far an exercise is, from its files and what is remembered, without building anything.

#include <companion/model/exercise.hpp>
#include <companion/model/state.hpp>

namespace companion {

enum class Progress {
    no_file,    // the learner's file is missing, or something else is in its place
    to_write,   // as it was shipped, or nothing of it written yet
    begun,      // some of it written, some still rt::todo
    unchecked,  // written, and changed since the last check
    failing,
    core,  // the core passes, and stars are open
    done
};

// Whether the core passes: then the learner goes on, and the learner's code runs.
bool passes(Progress progress);

Progress progress_of(const Course& course, const State& state, const Exercise& exercise);

// "done", "core passes", "failing", "not checked since it changed", "begun", "to be written", "a
// file is missing"
const char* text(Progress progress);

// A character that says the same without colors.
char symbol(Progress progress);

// The first of these exercises whose core does not pass; null if all pass.
const Exercise* first_open(const Course& course, const State& state,
                           const std::vector<Exercise>& exercises);

// How many stars are open in a chapter's exercises whose core passes.
int open_stars_of(const Course& course, const Chapter& chapter);

}  // namespace companion
