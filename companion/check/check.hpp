#pragma once
// Checking the learner's answers: build, run, judge, remember.

#include <companion/check/cases.hpp>
#include <companion/model/exercise.hpp>

namespace companion {

enum class Verdict {
    passed,        // the core; stars may be open
    failing,       // an assertion of the core does not hold, or an exception was thrown
    no_file,       // trouble says what is missing
    to_write,      // its own rt::todo is still there; trouble says what may cause that
    waiting,       // an exercise that it needs is still to be written
    not_compiled,  // trouble is the first error
    crashed,       // trouble says why
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
    std::vector<std::string> left;     // to_write: the functions still to write
    bool first_pass = false;           // passed: and never did before
    int stars = 0;                     // passed: how many there are
    std::vector<OpenStar> open_stars;  // passed: those that are open
};

// Checks these exercises, each in a program of its own, and remembers the verdicts. An exercise
// that is not begun is not built. Throws app::Failure if the build itself is broken.
std::vector<Checked> check_exercises(const Course& course, const std::vector<Exercise>& exercises);

// Tries those that pass, and that compute with rt::Real, once more with Real as float. If the core
// fails there, the verdict changes; a hard case that fails is an open star. Both are remembered.
// Returns how many were tried.
int check_in_float(const Course& course, std::vector<Checked>& all);

// How many of its test cases pass.
int passed_cases(const Checked& checked);

}  // namespace companion
