#pragma once
// Building what a command needs, with the existing build.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

struct BuildResult {
    bool ok = false;
    std::string output;  // everything that the build printed
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

// The line, with its paths written as the learner knows them: relative to the course.
std::string with_relative_paths(const Course& course, std::string line);

// The most helpful error of a compiler or linker in a build's output: the first in these files, or
// else the first that code in these files led to, or else the first of all. It reads
// "file:line:column: error: what"; further lines have the source that the compiler shows. Paths
// inside the course are relative to it. Empty if there is no error.
std::string first_error(const Course& course, const std::string& output,
                        const std::vector<fs::path>& files = {});

// A compiler's warning about these files, "file:line: what". It is the first one, but a warning
// about a missing return, a value that no longer exists or does not exist yet, or an endless
// recursion takes precedence. Empty if there is no warning.
std::string first_warning(const Course& course, const std::string& output,
                          const std::vector<fs::path>& files);

}  // namespace companion
