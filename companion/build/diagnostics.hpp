#pragma once
// What compilers and linkers say, read for the learner.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// A message of a compiler, "file:line:column: kind: what", and what belongs to it. Paths inside the
// course are relative to it.
struct Diagnostic {
    std::string at;    // "file:line:column"; the compiler's name if it has none
    std::string kind;  // "error", "fatal error", "warning" or "note"
    std::string what;
    std::string option = {};               // of a warning: "-Wreturn-type"
    std::vector<std::string> source = {};  // the lines that the compiler shows below it
    std::vector<std::string> from = {};    // how the compiler got there: lines with places
    std::vector<Diagnostic> notes = {};

    // "file:line"
    std::string place() const;
    bool is_in(const std::vector<fs::path>& files) const;
    // As g++ and clang++ print it, with at most so many lines of source.
    std::string text(std::size_t lines = 2) const;
};

// The errors and warnings in a build's output. It reads text, because the JSON of g++ 12 does not
// say which code made the compiler instantiate a template, and clang++ 14 has none.
std::vector<Diagnostic> read_diagnostics(const Course& course, const std::string& output);

// The line, with its paths written as the learner knows them: relative to the course.
std::string with_relative_paths(const Course& course, std::string line);

// The most helpful error of a compiler or linker in a build's output: the first in these files, or
// else the first that code in these files led to, or else the first of all. Its first line is
// "file:line:column: error: what"; further lines have the source that the compiler shows, and what
// to do about it. Empty if there is no error.
std::string first_error(const Course& course, const std::string& output,
                        const std::vector<fs::path>& files = {});

// A compiler's warning about these files, "file:line: what". It is the first one, but a warning
// about a missing return, a value that no longer exists or does not exist yet, or an endless
// recursion takes precedence. Empty if there is no warning.
std::string first_warning(const Course& course, const std::string& output,
                          const std::vector<fs::path>& files);

}  // namespace companion
