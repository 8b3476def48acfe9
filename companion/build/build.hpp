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

// Builds targets, in one step of the build; if one fails, the others are still built. Only one
// ./course builds at a time; another one waits. Nothing is printed.
BuildResult build(const Course& course, const std::vector<std::string>& targets);

// The same for a target that must exist afterward. Throws app::Failure with the first error.
void must_build(const Course& course, const std::string& target);

// The line with its paths as the learner knows them: relative to the course.
std::string with_relative_paths(const Course& course, std::string line);

// The most helpful error of a compiler or linker in a build's output: the first within these
// files, else the first that came from them, else the first of all. "file:line:column: error:
// what", and in further lines the source that the compiler shows. Paths inside the course are
// relative to it. Empty if there is none.
std::string first_error(const Course& course, const std::string& output,
                        const std::vector<fs::path>& files = {});

// A compiler's warning within these files, "file:line: what": the first, but a warning about a
// missing return, a value that no longer exists or not yet, or an endless recursion takes
// precedence. Empty if there is none.
std::string first_warning(const Course& course, const std::string& output,
                          const std::vector<fs::path>& files);

}  // namespace companion
