#pragma once
// course.json, which holds the facts of the course: its chapters and exercises.

#include <companion/model/exercise.hpp>

namespace companion {

struct CourseFile {
    std::vector<Chapter> chapters;
    std::vector<Exercise> exercises;  // of all chapters; what was shipped of them is not filled in
    std::vector<std::string> route;   // "NN.k" or "graft NN": each of the core's once
};

// Throws app::Failure if there is no such file, and app::UsageError, with the position in the file
// and what would be right, if its content is wrong.
CourseFile read_course_file(const Course& course);

}  // namespace companion
