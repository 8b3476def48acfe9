#pragma once
// An exercise's checkpoints under the compiler's sanitizers, which name the line of a crash.

#include <companion/model/exercise.hpp>
#include <string>

namespace companion {

// What a sanitizer's report says: what happened, and where in the learner's files. Empty if the
// output contains no report.
struct SanitizerReport {
    std::string what;   // "heap-use-after-free ..."
    std::string where;  // "exercises/00_toolchain/rt/canvas.hpp:31", the first within these files
};
SanitizerReport read_sanitizer_report(const std::string& output,
                                      const std::vector<fs::path>& files);

// "heap-use-after-free ... at exercises/00_toolchain/rt/canvas.hpp:31"
std::string to_text(const SanitizerReport& report);

// The words to put before a program's name on the command line so that it runs at addresses that
// are not randomized, if the system allows that: the thread sanitizer does not work with every way
// in which newer kernels randomize addresses.
std::vector<std::string> at_fixed_addresses();

// Builds and runs the checkpoints with the address and undefined-behavior sanitizers, or with the
// thread sanitizer. Throws app::Failure if the build fails.
struct SanitizedRun {
    bool passed = false;  // the checkpoints pass, and the sanitizers report nothing
    std::string words;    // what was reported
};
SanitizedRun run_sanitized(const Course& course, const Exercise& exercise, bool threads);

}  // namespace companion
