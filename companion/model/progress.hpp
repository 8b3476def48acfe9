#pragma once
// How far an exercise is, according to its files and to what is remembered; nothing is built.

#include <companion/model/exercise.hpp>
#include <companion/model/state.hpp>

namespace companion {

enum class Progress {
    no_file,    // the learner's file is missing, or is not a file
    to_write,   // as it was shipped, or nothing written yet
    begun,      // some of it is written, some is still rt::todo
    unchecked,  // written, and changed since the last check
    failing,
    core,  // the core passes, and stars are open
    done
};

// Whether the core passes: then the learner may go on, and the learner's code is used in programs.
bool passes(Progress progress);

Progress progress_of(const Course& course, const State& state, const Exercise& exercise);

// "done", "core passes", "failing", "not checked since it changed", "begun", "to be written", "a
// file is missing"
const char* text(Progress progress);

// A character for each state, so that colors are not needed.
char symbol(Progress progress);

// The first of these exercises whose core does not pass; null if every core passes.
const Exercise* first_open(const Course& course, const State& state,
                           const std::vector<Exercise>& exercises);

// How many stars are open in those exercises of a chapter whose core passes.
int open_stars_of(const Course& course, const Chapter& chapter);

}  // namespace companion
