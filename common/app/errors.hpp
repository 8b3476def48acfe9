#pragma once
// How every program of the course ends: with the right exit code, and one line on stderr where
// something was wrong.

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
    stopped_by = 128     // and the signal's number: 130 for Ctrl-C; the image shows what was done
};

// The command line or an input file is wrong. The message says what would be right.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Something that was asked for in the right way could not be done. The message says what and why.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Runs a program's work, which returns its exit code. Of an exception it makes one line on stderr
// and the exit code that belongs to it; so it does when the standard output cannot take what was
// printed. A file size limit that is hit is an error like a full disk, not the end of the program.
int run_or_explain(const std::string& program, const std::function<int()>& work);

}  // namespace app
