#pragma once
// The learner's own program, exercises/tracer/tracer.cpp, which grows with every chapter: where it
// is, how it is compiled, and what it draws.

#include <companion/compare/picture.hpp>
#include <companion/model/course.hpp>

namespace companion {

fs::path tracer_file(const Course& course);
fs::path tracer_scene(const Course& course);  // my.txt beside the program
// With `follows`, the one that records what a sample's light does: see companion/follow.
fs::path tracer_program(const Course& course, bool follows = false);

// Our answer to a chapter's graft, solutions/tracer/NN.cpp.
fs::path tracer_answer(const Course& course, const Chapter& chapter);

// Chapters up to this one that have a graft, in their order.
std::vector<Chapter> grafts(const Course& course);

// The next graft. On the way to it, the texts change the tracer step by step: then it is drawn and
// not judged.
struct NextGraft {
    Chapter chapter;       // whose headers the tracer may have
    bool is_ready = true;  // the exercises before it pass
    Chapter drawn;         // whose graft says what the tracer reads: this one, or the last one
};
NextGraft next_graft(const Course& course);

// The command that compiles a tracer with the headers of chapters up to this one; build/yours has
// the headers of the exercises. Paths are relative to the course. The first word is the compiler's
// name.
std::vector<std::string> tracer_command(const Course& course, const Chapter& last,
                                        bool follows = false);

// Compiles the one file of 00.1, as chapter 00 has it typed, and returns the program. Fails as
// compile_tracer does.
fs::path compile_first(const Course& course);

// Runs that command. If the compilation fails, throws app::Failure with the compiler's message; if
// the compiler only warns, its message goes to stderr.
void compile_tracer(const Course& course, const Chapter& last, bool follows = false);

// The headers <rt/NAME> that the last compilation of the tracer read.
std::vector<std::string> headers_of_tracer(const Course& course);

// A picture, and what the program that drew it printed.
struct Drawn {
    Picture picture;
    std::string printed;
};

// The tracer's picture when it is called with these words: the file `picture` if the program makes
// it, otherwise what it prints. Throws app::Failure if the program fails, draws nothing, or takes
// more than `timeout` seconds. At 0 it may take as long as it likes, and Ctrl-C ends it alone.
Drawn draw_by_tracer(const Course& course, const fs::path& program,
                     const std::vector<std::string>& words, const fs::path& picture,
                     double timeout = 0);

}  // namespace companion
