#pragma once
// Building what a command needs, with the build that is there.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

struct BuildResult {
    bool ok = false;
    std::string output;  // all that the build said
};

// Builds targets, in one step of the build; where one fails, the others are still built. Only one
// course at a time builds: another one waits. Nothing is printed.
BuildResult build(const Course& course, const std::vector<std::string>& targets);

// The same for a target that must be there. Throws app::Failure with the first error.
void must_build(const Course& course, const std::string& target);

// The error of a compiler or linker in a build's output that helps most: the first within these
// files, else the first that came from them, else the first: "file:line:column: error: what", and
// in further lines the source that the compiler shows. Paths are relative to the course where they
// are in it. Empty where there is none.
std::string first_error(const Course& course, const std::string& output,
                        const std::vector<fs::path>& files = {});

// A compiler's warning within these files, "file:line: what": the first, but one that tells of a
// missing return, a value that is gone or not there yet, or an endless recursion goes first. Empty
// where there is none.
std::string first_warning(const Course& course, const std::string& output,
                          const std::vector<fs::path>& files);

}  // namespace companion
