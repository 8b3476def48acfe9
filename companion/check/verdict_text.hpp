#pragma once
// Telling the learner what a check found.

#include <companion/check/check.hpp>
#include <companion/check/known_mistakes.hpp>
#include <string>

namespace companion {

// One line: symbol, exercise, title, verdict.
std::string summary_line(const Checked& checked);

// The lines for those exercises in which the check in float found something.
std::string float_lines(const std::vector<Checked>& all);

// What is wrong with an answer that does not pass: expected and actual values, the mistake that it
// resembles, where to read. Several lines.
std::string details(const Checked& checked, const LooksLike& looks_like);

// For an exercise whose core passes: its open stars, all of them or only the first, and the
// compiler's warning. Empty if no star is open.
std::string open_stars(const Checked& checked, const LooksLike& looks_like, bool all);

// "2 stars open".
std::string stars_open(int count);

}  // namespace companion
