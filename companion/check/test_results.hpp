#pragma once
// What a program of test cases said: the lines that the reporter of tests/support/main.cpp writes.
// Texts that come from the tested code are printable.

#include <string>
#include <vector>

namespace companion {

// An assertion that did not hold, or an unexpected exception.
struct FailedAssertion {
    std::string expression;             // as in the test's source: "CHECK( a == b )"
    std::string expanded;               // with the values: "1 == 2"
    std::string exception;              // what was thrown, if anything
    std::vector<std::string> messages;  // what the test says: expected and actual values, hints
    std::string missing;  // the exercise whose rt::todo was thrown, such as "01.3", or none
};

struct TestCase {
    std::string name;   // "01.3 the length follows from Pythagoras"
    bool hard = false;  // a star, not a part of the core
    bool passed = false;
    bool ended = false;  // false: it was running when the program ended
    std::string crash;   // what the program died of within it, "SIGSEGV - Segmentation ..."
    std::string
        memory;        // if it died of a use of memory, where that was: "null", "stack", or unknown
    int computed = 0;  // if it was ended since it got no further: for how many seconds
    std::string output;  // what it printed
    std::vector<FailedAssertion> failures;
};

struct Report {
    std::vector<TestCase> tests{};     // that were begun, in their order
    std::vector<TestCase> compiled{};  // all that the program has, as far as is known before a run
    bool exited = false;               // the tested code called exit()
};

// Each line begins with the secret word of the run; others do not count, since the tested code
// wrote them. The lines may end anywhere, as when a program was killed.
Report read_report(const std::string& lines, const std::string& secret = "");

// The exercise whose rt::todo ended a test case, such as "01.3"; empty if none did.
std::string missing_exercise(const TestCase& test);

}  // namespace companion
