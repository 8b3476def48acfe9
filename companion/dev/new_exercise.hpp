#pragma once
// Begins a new exercise of the course.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// The word that marks what a person must still write.
inline constexpr const char* unwritten = "UNWRITTEN";

// Makes all files of exercise "NN.k", which must be the next one of its chapter, from the templates
// in exercise.txt, and adds the exercise to course.json, the text and the hints. `name` is the name
// of its function and of its header, rt/NAME.hpp. The result can be built. Returns the files.
// Throws app::UsageError, without having changed anything, if the number or the name is taken or
// invalid.
std::vector<fs::path> begin_exercise(const Course& course, const std::string& id,
                                     const std::string& name);

}  // namespace companion
