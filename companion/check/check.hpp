#pragma once
// Checking the learner's answers: build, run, judge, remember.

#include <companion/check/recognition.hpp>
#include <companion/check/test_results.hpp>
#include <companion/model/exercise.hpp>

namespace companion {

enum class Verdict {
    passed,        // the core; stars may be open
    failing,       // an assertion of the core does not hold, or an exception came
    no_file,       // trouble says what is missing
    to_write,      // its own rt::todo is still there; trouble says what that may come from
    waiting,       // an exercise that it needs is still to be written
    not_compiled,  // trouble is the first error
    crashed,       // trouble says of what
    endless        // it was stopped
};

// A hard test case that fails in an answer whose core passes.
struct OpenStar {
    TestCase test;
    bool in_float = false;  // it passes in double
    std::string trouble{};  // what the program died of in it, or that it was stopped
};

struct Checked {
    Exercise exercise;
    Verdict verdict = Verdict::to_write;
    std::vector<TestCase> tests;       // as far as they were run
    bool in_float = false;             // the verdict is on its float build, after double passed
    std::string trouble;               // what kept it from running to the end
    std::string warning;               // of the compiler, on its files
    std::string missing;               // waiting: the exercise that it needs
    std::vector<std::string> left;     // to_write: the functions that are
    std::vector<LookAlikes> mistakes;  // that it looks like
    bool first_pass = false;           // passed: and never did before
    int stars = 0;                     // passed: how many there are
    std::vector<OpenStar> open_stars;  // passed: those that are open
};

// Seconds after which an exercise's checkpoints are stopped.
inline constexpr double most_seconds = 20;

// Checks these exercises, each in a program of its own, and remembers the verdicts. One of which
// nothing is written is not built. Throws app::Failure where the build itself is broken.
std::vector<Checked> check_exercises(const Course& course, const std::vector<Exercise>& exercises);

// Tries those that pass, and that compute with rt::Real, once more with Real as float. The verdict
// of those whose core fails there changes, a hard case that fails is an open star, and both are
// remembered. Returns how many were tried.
int check_in_float(const Course& course, std::vector<Checked>& all);

// How many of its test cases pass, and how many there are. Of one that was stopped, those that were
// begun.
int passed_cases(const Checked& checked);

}  // namespace companion
