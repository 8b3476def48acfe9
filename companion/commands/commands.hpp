#pragma once
// The commands of the companion, each in a file of its own.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

using Arguments = std::vector<std::string>;  // what follows the command's name

// Each returns the exit code.
int check(const Course& course, const Arguments& arguments);
int certify(const Course& course, const Arguments& arguments);
int compare(const Course& course, const Arguments& arguments);
int demo(const Course& course, const Arguments& arguments);
int hint(const Course& course, const Arguments& arguments);
int list(const Course& course, const Arguments& arguments);
int mine(const Course& course, const Arguments& arguments);
int reset(const Course& course, const Arguments& arguments);
int run(const Course& course, const Arguments& arguments);
int study(const Course& course, const Arguments& arguments);
int watch(const Course& course, const Arguments& arguments);

}  // namespace companion
