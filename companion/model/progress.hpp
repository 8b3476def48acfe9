#pragma once
// How far an exercise is, from its files and what is remembered: nothing is built.

#include <companion/model/exercise.hpp>
#include <companion/model/state.hpp>

namespace companion {

enum class Progress {
    to_write,   // as it was shipped, or nothing of it written yet
    begun,      // some of it written, some still rt::todo
    unchecked,  // written, and changed since the last check
    failing,
    done
};

Progress progress_of(const Course& course, const State& state, const Exercise& exercise);

// "done", "failing", "not checked since it changed", "begun", "to be written"
const char* text(Progress progress);

// A character that says the same where there are no colors.
char symbol(Progress progress);

// Of these exercises, the first that is not done; null where all are.
const Exercise* first_not_done(const Course& course, const State& state,
                               const std::vector<Exercise>& exercises);

}  // namespace companion
