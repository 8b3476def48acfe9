#pragma once
// Telling the learner what a check found.

#include <companion/check/check.hpp>
#include <string>

namespace companion {

// One line: symbol, exercise, title, verdict.
std::string summary_line(const Checked& checked);

// Checks in float, too: the lines of those that it found something in, or that all is well.
std::string float_lines(const Course& course, std::vector<Checked>& all);

// What is wrong with an answer that does not pass: expected and computed values, what it looks
// like, where to read. Several lines.
std::string details(const Course& course, const Checked& checked);

// Of an exercise whose core passes: the stars that are open, all of them or the first. Empty where
// none is.
std::string open_stars(const Course& course, const Checked& checked, bool all);

// "2 stars open".
std::string stars_open(int count);

// What to do next, given that these exercises (all of them in order) were just checked or are
// known.
std::string next_step(const Course& course, const Exercise* next);

// When the core of a chapter is done.
std::string chapter_done(const Chapter& chapter, int open_stars);

}  // namespace companion
