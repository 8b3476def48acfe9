#pragma once
// Builds beside the main one, with other settings, so that the main one stays as it is.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// The folder build/NAME, configured like the main build except for these arguments of CMake. What
// was built there before stays. Throws app::Failure if CMake fails.
Course side_build(const Course& course, const std::string& name,
                  const std::vector<std::string>& arguments);

// The value of a variable in the build's cache, such as CMAKE_CXX_COMPILER; empty if it has none.
std::string cached(const Course& course, const std::string& variable);

}  // namespace companion
