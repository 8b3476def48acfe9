#pragma once
// Building what a command needs, with the existing build.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

struct BuildResult {
    bool ok = false;
    std::string output;      // everything that the build printed
    double cpu_seconds = 0;  // of processor time
};

// Builds targets in one run of the build tool; if one target fails, the others are still built.
// Only one ./course builds at a time; any other waits. Nothing is printed, except on a terminal
// that it waits for what is built ahead.
BuildResult build(const Course& course, const std::vector<std::string>& targets);

// The same for a caller that has the Turn already.
BuildResult build_in_turn(const Course& course, const std::vector<std::string>& targets);

// The same for one target, without which the caller cannot go on. Throws app::Failure with the
// first error.
void must_build(const Course& course, const std::string& target);

}  // namespace companion
