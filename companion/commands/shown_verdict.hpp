#pragma once
// Shows a verdict at once, and then, as soon as they are known, the known mistakes that the answer
// resembles: to find them may take seconds.

#include <companion/check/check.hpp>
#include <companion/system/terminal.hpp>
#include <functional>

namespace companion {

// Whether nobody waits for the mistakes any longer.
using IsOver = std::function<bool()>;

// What is wrong with an answer that does not pass, and where to read; `say` gets it part by part.
void print_details(
    const Course& course, const Checked& checked, const IsOver& is_over = [] { return false; },
    const std::function<void(const std::string&)>& say = print);

// The open stars of an answer whose core passes. Nothing if none is open.
void print_open_stars(const Course& course, const Checked& checked);

}  // namespace companion
