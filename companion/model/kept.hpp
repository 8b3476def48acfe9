#pragma once
// What the learner wrote is never lost: before a file is replaced, it is copied to .course/kept.

#include <companion/model/course.hpp>
#include <string>

namespace companion {

// A new folder, .course/kept/01.3-20260131-174500, with -2, -3, ... at the end if that name exists
// already.
fs::path new_kept_folder(const Course& course, const std::string& name);

}  // namespace companion
