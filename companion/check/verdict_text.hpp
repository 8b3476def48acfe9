#pragma once
// Telling the learner what a check found.

#include <companion/check/check.hpp>
#include <string>

namespace companion {

// One line: symbol, exercise, title, verdict.
std::string summary_line(const Checked& checked);

// What is wrong with an answer that does not pass: expected and computed values, what it looks
// like, where to read. Several lines.
std::string details(const Course& course, const Checked& checked);

// What to do next, given that these exercises (all of them in order) were just checked or are
// known.
std::string next_step(const Course& course, const Exercise* next);

// When all of a chapter is done.
std::string chapter_done(const Chapter& chapter);

}  // namespace companion
