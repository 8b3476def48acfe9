#pragma once
// The verdict on a ray tracer of the learner's own, from the pictures that it draws and the time
// that it takes.

#include <companion/own/own_program.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace companion {

// One line: what was looked at, what was found, what was asked for.
struct JudgedLine {
    bool passed = false;
    std::string what;        // "rung 3: one matte ball on the ground"
    std::string actual;      // "every tile within the noise", "0.8 times"
    std::string expected;    // "the reference's picture", "at least 10 times"
    std::string suggestion;  // where it failed
};

struct JudgeRequest {
    fs::path folder, reference;  // the learner's folder, and the course's own program
    std::uint64_t seed = 1;      // of the scenes
    int rung = 0;                // only this one; 0: everything
    int cores = 2;               // physical ones
};

// What accuracy.md says of a choice: an option for the compiler, and the figures that the learner
// wrote.
struct AccuracyChoice {
    std::string option;
    std::optional<double> time, error;
};
std::vector<AccuracyChoice> accuracy_choices(const std::string& page);

// Judges, and hands out each line as soon as it is known. Throws app::Failure where the program
// cannot be built. True if all lines passed.
bool judge(const JudgeRequest& request, const std::function<void(const JudgedLine&)>& report);

}  // namespace companion
