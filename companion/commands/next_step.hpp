#pragma once
// Where the learner goes from here.

#include <companion/model/route.hpp>
#include <string>

namespace companion {

// What to do next, if this is the step for it; none: all steps of the core are done.
std::string next_step(const Course& course, const std::optional<Step>& next);
std::string next_step(const Course& course, const Exercise& next);

// When the core of a chapter is done.
std::string chapter_done(const Chapter& chapter, int open_stars);

}  // namespace companion
