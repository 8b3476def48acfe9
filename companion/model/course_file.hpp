#pragma once
// course.json, where the facts of the course stand: its chapters and exercises.

#include <companion/model/exercise.hpp>

namespace companion {

struct CourseFile {
    std::vector<Chapter> chapters;
    std::vector<Exercise> exercises;  // of all chapters; what was shipped of them is not filled in
};

// Throws app::Failure where there is no such file, and app::UsageError, with the place in the file
// and what would be right, where it is not as it should be.
CourseFile read_course_file(const Course& course);

}  // namespace companion
