#pragma once
// The learner's own program, exercises/tracer/tracer.cpp, which grows with every chapter: where it
// is, how it is compiled, and what it draws.

#include <companion/compare/picture.hpp>
#include <companion/model/course.hpp>

namespace companion {

fs::path tracer_file(const Course& course);
fs::path tracer_scene(const Course& course);  // my.txt beside it
fs::path tracer_program(const Course& course);

// The program that a chapter's graft leads to, solutions/tracer/NN.cpp.
fs::path tracer_answer(const Course& course, const Chapter& chapter);

// Chapters up to this one that have a graft, in their order.
std::vector<Chapter> grafts(const Course& course);

// The command that compiles a tracer with the headers of chapters up to this one: build/yours has
// those of the exercises. Paths are relative to the course. Its first word is the compiler's name.
std::vector<std::string> tracer_command(const Course& course, const Chapter& last);

// Runs that command. What the compiler said is shown in the error, app::Failure, or on stderr if
// it only warned.
void compile_tracer(const Course& course, const Chapter& last);

// Which headers <rt/NAME> the last compilation of the tracer read.
std::vector<std::string> headers_of_tracer(const Course& course);

// A picture, and what the program that made the file printed.
struct Drawn {
    Picture picture;
    std::string printed;
};

// What the tracer draws when it is called with these words: the file `picture` if the program makes
// it, else what it prints. Throws app::Failure if it fails or draws nothing.
Drawn draw_by_tracer(const Course& course, const fs::path& program,
                     const std::vector<std::string>& words, const fs::path& picture);

}  // namespace companion
