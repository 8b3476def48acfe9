#pragma once
// Where the learner goes from here.

#include <companion/model/route.hpp>
#include <string>

namespace companion {

// What to do next, in words, if `next` is the next step. If it is none, all steps of the core are
// done.
std::string next_step(const Course& course, const std::optional<Step>& next);
std::string next_step(const Course& course, const Exercise& next);

// The next step in the chapter with a task, which the course has.
std::string next_of_own(const Course& course);

// What to say when the core of a chapter is done.
std::string chapter_done(const Chapter& chapter, int open_stars);

}  // namespace companion
