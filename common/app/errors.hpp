#pragma once
// How every program of the course ends: with the right exit code, and with one line on
// stderr if something was wrong.

#include <functional>
#include <stdexcept>
#include <string>

namespace app {

// Exit codes of all programs of the course.
enum ExitCode {
    done = 0,
    could_not = 1,       // the disk is full, a permission is missing, ...
    bad_input = 2,       // the command line or an input file is wrong
    still_to_write = 3,  // the program needs an exercise that is not written yet
    stopped_by = 128     // plus the signal's number: 130 for Ctrl-C; the image shows what was done
};

// The command line or an input file is wrong. The message says what would be right.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A valid request could not be carried out. The message says what failed and why.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Runs a program's work, which returns its exit code. Turns an exception into one line on stderr
// and the exit code that belongs to it. It does the same if the standard output does not accept
// what was printed. A file that reaches its size limit is an error like a full disk, and does not
// kill the program.
int run_or_explain(const std::string& program, const std::function<int()>& work);

}  // namespace app
