#pragma once
// Where the learner goes from here.

#include <companion/model/exercise.hpp>
#include <string>

namespace companion {

// What to do next, if this is the exercise for it; null: every exercise passes.
std::string next_step(const Course& course, const Exercise* next);

// When the core of a chapter is done.
std::string chapter_done(const Chapter& chapter, int open_stars);

}  // namespace companion
