#pragma once
// The commands of the companion, each in a file of its own.

#include <course/course.hpp>
#include <string>
#include <vector>

namespace course {

using Arguments = std::vector<std::string>;  // what follows the command's name

// Each returns the exit code.
int demo(const Course& course, const Arguments& arguments);
int study(const Course& course, const Arguments& arguments);

}  // namespace course
