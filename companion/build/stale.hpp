#pragma once
// A build compares time stamps. They say nothing where a file comes back with an older one: moved
// from a backup, copied with cp -p, unpacked from an archive, saved with a clock that was set back.
// Nor do they where a header is added that is found before another one. What counts is what is in
// the files.

#include <companion/model/course.hpp>

namespace companion {

// Before a build: removes what was built of a chapter of exercises/, or of build/yours, where the
// files there are others now and the build would not see that.
void remove_stale(const Course& course);

// After the build, whether it succeeded or not: notes of which files it was, in the folder of the
// build.
void note_built(const Course& course);

}  // namespace companion
