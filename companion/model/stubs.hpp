#pragma once
// The stubs as they were shipped. The learner writes over them, so the companion keeps a copy of
// each, in .course/stubs, when it first sees it.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// Keeps the stubs that are kept nowhere yet, or that an update of the course has changed. A stub is
// kept as long as each of its rt::todo is there. What cannot be written is not kept.
void keep_stubs(const Course& course);

// The stub of a file such as exercises/01_vectors/rt/dot.hpp: as it was kept, else as it is now if
// something in it is still to be written. Empty if nobody knows.
std::string shipped_stub(const Course& course, const fs::path& file);

// How often a source calls rt::todo("NN.k"), or rt::todo for any exercise; comments do not count.
int count_todos(const std::string& source, const std::string& exercise);
int count_todos(const std::string& source);

// The functions of a source that contain an rt::todo of the exercise, by name, each once.
std::vector<std::string> functions_to_write(const std::string& source, const std::string& exercise);

}  // namespace companion
