#pragma once
// The results of a program of test cases, from the lines that the reporter in
// tests/support/main.cpp writes. Texts that come from the tested code are made printable.

#include <string>
#include <vector>

namespace companion {

// What a test says about an assertion: see tests/support/catch.hpp.
struct Message {
    std::string text;              // for the learner: values, hints
    std::string expected, actual;  // the values that the text names, if it does
    bool if_it_crashes = false;    // it helps only if the code crashes
    std::string counts{};          // what was counted, and expected: see counts.hpp

    // Whether the text shows two values that differ. If they are the same, the message belongs to
    // an earlier assertion, or shows too few digits.
    bool compares() const;
};

// An assertion that did not hold, or an unexpected exception.
struct FailedAssertion {
    std::string expression;  // as in the test's source: "CHECK( a == b )"
    std::string expanded;    // with the values: "1 == 2"
    std::string exception;   // what was thrown, if anything
    std::vector<Message> messages;
    std::string missing;  // the exercise whose rt::todo was thrown, such as "01.3"; or none

    // The last message that names an expected value; null if none does. Others that do so belong to
    // earlier assertions.
    const Message* expectation() const;
};

struct TestCase {
    std::string name;   // "01.3 the length follows from Pythagoras"
    bool hard = false;  // a star, not a part of the core
    bool passed = false;
    bool ended = false;  // false: it was still running when the program ended
    std::string crash;   // how the program crashed in it, "SIGSEGV - Segmentation ..."
    std::string
        memory;  // if it died of a use of memory, where that was: "null", "stack", or unknown
    // For how many seconds, if it was ended for computing or for waiting too long.
    int computed = 0, waited = 0;
    std::string output;  // what it printed
    std::vector<FailedAssertion> failures;

    // Whether the program ended in it.
    bool broke_off() const { return !ended || !crash.empty(); }
};

struct Report {
    std::vector<TestCase> tests{};     // that were begun, in their order
    std::vector<TestCase> compiled{};  // all in the program, as far as known before the run
    bool exited = false;               // the tested code called exit()
};

// Each line begins with the run's secret word; any other line is ignored, because the tested code
// wrote it. The lines may break off anywhere, as when a program was killed.
Report read_report(const std::string& lines, const std::string& secret = "");

// The exercise whose rt::todo ended a test case, such as "01.3"; empty if none did.
std::string missing_exercise(const TestCase& test);

}  // namespace companion
