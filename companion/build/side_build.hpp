#pragma once
// Builds beside the main one, with other settings, so that the main one stays as it is.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// The folder build/NAME, configured like the main build but for these arguments of CMake. What was
// built there before stays. Throws app::Failure where CMake fails.
Course side_build(const Course& course, const std::string& name,
                  const std::vector<std::string>& arguments);

// What the build's cache says of a variable, such as CMAKE_CXX_COMPILER; empty where nothing.
std::string cached(const Course& course, const std::string& variable);

}  // namespace companion
