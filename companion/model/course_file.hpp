#pragma once
// Reads course.json, which holds the facts of the course: its chapters and exercises.

#include <companion/model/exercise.hpp>

namespace companion {

struct CourseFile {
    std::vector<Chapter> chapters;
    std::vector<Exercise> exercises;  // of all chapters, without the members about shipped stubs
    std::vector<std::string> route;   // "NN.k" or "graft NN": each step of the core once
};

// Throws app::Failure if there is no such file. If its content is wrong, throws app::UsageError,
// which names the position in the file and what would be right.
CourseFile read_course_file(const Course& course);

}  // namespace companion
