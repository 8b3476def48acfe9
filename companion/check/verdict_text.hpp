#pragma once
// Telling the learner what a check found.

#include <companion/check/check.hpp>
#include <string>

namespace companion {

// One line: symbol, exercise, title, verdict.
std::string summary_line(const Checked& checked);

// Checks in float, too. Returns the lines of those in which it found
// something, or that all is well.
std::string float_lines(const Course& course, std::vector<Checked>& all);

// What is wrong with an answer that does not pass: expected and actual values, what it looks like,
// where to read. Several lines.
std::string details(const Course& course, const Checked& checked);

// For an exercise whose core passes: the stars that are open, all of them or the
// first. Empty if none is open.
std::string open_stars(const Course& course, const Checked& checked, bool all);

// "2 stars open".
std::string stars_open(int count);

// What to do next, if these exercises (all of them in order) were just checked or are known.
std::string next_step(const Course& course, const Exercise* next);

// When the core of a chapter is done.
std::string chapter_done(const Chapter& chapter, int open_stars);

}  // namespace companion
