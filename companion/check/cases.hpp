#pragma once
// Running an exercise's test cases on an answer.

#include <companion/check/test_results.hpp>
#include <companion/model/course.hpp>
#include <companion/system/process.hpp>

namespace companion {

// One run of an exercise's program of test cases.
struct Tested {
    Result result;
    std::vector<TestCase> tests;
    bool left_early = false;  // it ended by itself before all of the test cases had ended

    // The test case in which the program crashed or was stopped; null if it ran to its end.
    const TestCase* ended_in() const;
    // The test program ended itself, since the tested code computed for too long.
    bool got_no_further() const { return ended_in() && ended_in()->computed > 0; }
    bool was_stopped() const { return result.timed_out || result.too_much || got_no_further(); }
    bool waited() const { return result.timed_out && 2 * result.cpu_seconds < result.seconds; }
    bool crashed() const { return ended_in() || result.signal != 0; }
    // What ended it, for a person.
    std::string trouble() const;
};

// Which answer an exercise's checkpoints are run on, and how.
struct Cases {
    std::string exercise;  // "03.2"
    bool in_float = false;
    fs::path answer = {};  // the folder of the answer; empty: the learner's
    // Of these test cases: all, the core or the stars; without some; or one alone.
    enum class Part { all, core, stars } part = Part::all;
    std::vector<std::string> without = {};
    std::string only = {};
    double timeout = 0;  // in seconds; 0: the course's patience
};
Tested run_cases(const Course& course, const Cases& cases);

// The command that runs them on the answer, and shows what fails; with a secret word, it lists what
// happens, each event after that word.
std::vector<std::string> command_of(const Course& course, const Cases& cases,
                                    const std::string& secret = "");

// The folder of the learner's answers in this precision; of each exercise there is one.
fs::path yours_folder(const Course& course, bool in_float);

// "libanswer.03.2.so", as the checkpoint looks for it; "answer.00.1" for a program of its own.
std::string answer_file(const Course& course, const std::string& exercise);

}  // namespace companion
