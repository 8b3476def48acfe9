#pragma once
// Beginning a new exercise of the course.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// The word that marks what a person must still write.
inline constexpr const char* unwritten = "UNWRITTEN";

// Makes all files of exercise "NN.k", which must be the next of its chapter, as exercise.txt has
// them, and adds its parts to course.json, the text and the hints. `name` is that of its function
// and its header, rt/NAME.hpp. What it makes can be built. Returns the files. Throws
// app::UsageError, and has changed nothing, if the number or the name is taken or not one.
std::vector<fs::path> begin_exercise(const Course& course, const std::string& id,
                                     const std::string& name);

}  // namespace companion
