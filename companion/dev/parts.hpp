#pragma once
// Whether an exercise has all of its parts, and whether they are right.

#include <companion/model/exercise.hpp>
#include <string>
#include <vector>

namespace companion {

// The files that the exercise needs but does not have, one per line.
std::vector<std::string> missing_files(const Course& course, const Exercise& exercise);

// What is missing or wrong in the files of an exercise as they are written, one line each, with
// what would be right. Asks clang-format where it is installed. Builds nothing.
std::vector<std::string> wrong_parts(const Course& course, const Exercise& exercise);

// The same for what is built from the files: solution, stub, checkpoint, mistakes. Takes a few
// seconds.
std::vector<std::string> wrong_when_run(const Course& course, const Exercise& exercise);

// The same for the pictures of the core: what the test dead_ends says of this exercise. Building it
// takes a minute.
std::vector<std::string> wrong_in_pictures(const Course& course, const Exercise& exercise);

// What this machine lacks the tools for, one line each.
std::vector<std::string> not_asked(const Course& course, const Exercise& exercise);

}  // namespace companion
