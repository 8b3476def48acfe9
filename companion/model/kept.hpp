#pragma once
// What the learner wrote is never lost: before a file is replaced, it is kept in .course/kept.

#include <companion/model/course.hpp>
#include <string>

namespace companion {

// A new folder, .course/kept/01.3-20260131-174500, or with -2, -3, ... if that already exists.
fs::path new_kept_folder(const Course& course, const std::string& name);

}  // namespace companion
