#pragma once
// The stubs as they were shipped. The learner writes over them, so the companion stores a copy of
// each in .course/stubs when it first sees it.

#include <companion/model/course.hpp>
#include <string>
#include <vector>

namespace companion {

// Stores copies of the stubs that have none yet, or that an update of the course has changed. A
// file counts as a stub only while none of its rt::todo is missing. If a copy cannot be written,
// there is none.
void keep_stubs(const Course& course);

// The stub for a file such as exercises/01_vectors/rt/dot.hpp: the copy, or else the file as it is
// now if something in it is still to be written. Empty if neither is available.
std::string shipped_stub(const Course& course, const fs::path& file);

// What a stub says of the core: for each comment, its lines before "Star:" and "Source:", and the
// declaration below them.
std::string core_contract(const std::string& stub);

// How often a source calls rt::todo("NN.k"), or rt::todo for any exercise; comments do not count.
int count_todos(const std::string& source, const std::string& exercise);
int count_todos(const std::string& source);

// The names of a source's functions that contain an rt::todo of the exercise, each once.
std::vector<std::string> functions_to_write(const std::string& source, const std::string& exercise);

}  // namespace companion
