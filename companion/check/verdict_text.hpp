#pragma once
// Telling the learner what a check found.

#include <companion/check/check.hpp>
#include <companion/check/known_mistakes.hpp>
#include <string>

namespace companion {

// One line: symbol, exercise, title, verdict. If stars are open, it also says which command shows
// them, if one is given.
std::string summary_line(const Checked& checked, const std::string& stars_command = "");

// The lines for those exercises in which the check in float found something.
std::string float_lines(const std::vector<Checked>& all, const std::string& stars_command = "");

// What is wrong with an answer that does not pass: expected and actual values. Several lines. Of
// several test cases that fail, the one named `telling` is shown, or else the first.
std::string details(const Checked& checked, const std::string& telling = "");

// For an exercise whose core passes: its open stars, and the compiler's warning. Empty if no star
// is open.
std::string open_stars(const Checked& checked);

// After these: the known mistakes that the answer resembles, each by itself.
std::string looks_like(const Mistake& mistake, Joins joins);

// Then where to read.
std::string where_to_read(const Checked& checked);

// "2 stars open".
std::string stars_open(int count);

}  // namespace companion
