#pragma once
// A build compares time stamps. They are misleading if a file comes back with an older one: moved
// from a backup, copied with cp -p, unpacked from an archive, saved with a clock that was set back.
// They are also misleading if a header is added that is found before another one. What counts is
// the content of the files.

#include <companion/model/course.hpp>

namespace companion {

// Before a build: removes what was built from a chapter of exercises/, or from build/yours, if the
// files there have changed and the build would not notice.
void remove_stale(const Course& course);

// After the build, whether it succeeded or not: records which files it used, in
// the folder of the build.
void note_built(const Course& course);

}  // namespace companion
