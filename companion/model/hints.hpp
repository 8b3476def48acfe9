#pragma once
#include <companion/model/exercise.hpp>

namespace companion {

// The hints of an exercise, from its chapter's file of hints: the ordered list below the heading
// "## NN.k". None if the file or the heading is missing.
std::vector<std::string> hints(const Course& course, const Exercise& exercise);

}  // namespace companion
