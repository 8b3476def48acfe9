#pragma once
// A build compares time stamps. They are misleading if an older file takes a file's place: moved
// from a backup, copied with cp -p, unpacked from an archive, or saved while the clock was set
// back. They are also misleading if a header is added that the compiler finds before another one.
// So this code compares the contents of the files.

#include <companion/model/course.hpp>

namespace companion {

// Before a build: if files of a chapter in exercises/, or files in build/yours, have changed in a
// way that the build would not notice, removes what was built from them.
void remove_stale(const Course& course);

// After the build, whether it succeeded or not: records which files it used, in
// the folder of the build.
void note_built(const Course& course);

}  // namespace companion
