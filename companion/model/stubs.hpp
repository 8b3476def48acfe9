#pragma once
// The stubs as they were shipped. The learner writes over them, so they are kept a second time, all
// of a chapter in one file, companion/shipped_stubs/NN_topic.txt. Git could bring them back as
// well, but only from a clone, and only while the learner has not committed an answer.

#include <companion/model/course.hpp>
#include <map>
#include <string>

namespace companion {

using Stubs = std::map<fs::path, std::string>;  // "rt/dot.hpp" and its content

// Throws app::Failure if the file is missing or not in this format.
Stubs shipped_stubs(const Course& course, const Chapter& chapter);

// The stubs of exercises/NN_topic as they are now.
Stubs present_stubs(const Course& course, const Chapter& chapter);

std::string to_text(const Stubs& stubs);
Stubs stubs_from_text(const std::string& text);

// How often a source calls rt::todo("NN.k"); comments do not count.
int count_todos(const std::string& source, const std::string& exercise);

// The functions of a source that contain an rt::todo of the exercise, by name, each once.
std::vector<std::string> functions_to_write(const std::string& source, const std::string& exercise);

}  // namespace companion
