#pragma once
// Checking the learner's answers: build, run, judge, remember.

#include <companion/check/cases.hpp>
#include <companion/model/exercise.hpp>
#include <functional>
#include <variant>

namespace companion {

// A hard test case that fails in an answer whose core passes.
struct OpenStar {
    TestCase test;
    bool in_float = false;  // only in float: it passes in double
    std::string trouble{};  // what ended the program in this test case, or that it was stopped
};

// The verdicts on an answer, each with what is known about the answer. `tests` are the test cases
// that began to run. A verdict's `says` follows the exercise's number, as in "01.3 fails".

struct Passed {  // the core; stars may be open
    static constexpr const char* says = "passes";
    std::vector<TestCase> tests{};
    int stars = 0;  // how many hard test cases there are
    std::vector<OpenStar> open_stars{};
};
struct Failing {  // an assertion of the core does not hold, or an exception was thrown
    static constexpr const char* says = "fails";
    std::vector<TestCase> tests{};
    std::string reason{};  // why the test cases do not call the learner's code; usually empty
};
struct Crashed {
    static constexpr const char* says = "crashes";
    std::vector<TestCase> tests{};
    std::string cause{};
};
struct Left {  // the answer ended the program, or kept it from reporting
    static constexpr const char* says = "ends the program";
    std::vector<TestCase> tests{};
};
struct Endless {  // the program was stopped
    static constexpr const char* says = "does not end";
    std::vector<TestCase> tests{};
    std::string cause{};
    bool waits = false;  // the program spent most of the time waiting, not computing
};
struct NotCompiled {
    static constexpr const char* says = "does not compile";
    std::string error{};  // the first one
};
struct NotBegun {  // the files are as they were shipped
    static constexpr const char* says = "is still to be written";
};
struct Begun {  // some rt::todo of this exercise are still in the files
    static constexpr const char* says = NotBegun::says;
    std::vector<TestCase> tests{};
    std::vector<std::string> left{};  // the functions still to write
    std::string hint{};
};
struct Waiting {
    static constexpr const char* says = "needs another exercise first";
    std::string missing{};  // the other exercise
};
struct NoFile {
    static constexpr const char* says = "has a missing file";
    std::string trouble{};  // what is missing
};
using Verdict = std::variant<NotBegun, Begun, Waiting, NoFile, NotCompiled, Crashed, Left, Endless,
                             Failing, Passed>;

struct Checked {
    Exercise exercise;
    Verdict verdict{};
    bool in_float = false;  // the verdict is on the float build; the double build passed
    bool is_built = false;  // in every precision that is checked
    std::string warning{};  // the compiler's warning about the exercise's files
    std::string slip{};  // what no compiler warns of, "file:line: what": see dropped_fraction.hpp

    // What is known of an answer that passed; null for any other.
    const Passed* passed() const { return std::get_if<Passed>(&verdict); }
    template <class Kind>
    bool is() const {
        return std::holds_alternative<Kind>(verdict);
    }
    // The exercise's test cases that began to run, and how many of them pass.
    const std::vector<TestCase>& tests() const;
    int passed_cases() const;
};

// Checks these exercises, each in a program of its own, and remembers the verdicts. An exercise
// that the learner has not begun is not built. Those that pass and that compute with rt::Real are
// checked once more, with Real as float: if the core fails there, that is the verdict, and a hard
// case that fails is an open star. Before that, `tell` gets what is known so far, because a learner
// waits for it. Throws app::Failure if the build itself is broken.
std::vector<Checked> check_exercises(
    const Course& course, const std::vector<Exercise>& exercises,
    const std::function<void(const std::vector<Checked>&)>& tell = [](const auto&) {});

// Compiles the test cases of an exercise in both precisions, so that its first check need only
// compile the answer. If something cannot be built, that check will report it.
void prepare_check(const Course& course, const Exercise& exercise);

}  // namespace companion
