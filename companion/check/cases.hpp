#pragma once
// Running an exercise's test cases on an answer.

#include <companion/check/test_results.hpp>
#include <companion/model/exercise.hpp>
#include <companion/system/process.hpp>

namespace companion {

// Whether a learner at this exercise has met threads, which come with chapter 06.
bool knows_threads(const std::string& exercise);

// One run of an exercise's program of test cases.
struct Tested {
    std::string exercise;
    Result result;
    std::vector<TestCase> tests;
    bool left_early = false;  // it ended by itself before all test cases had ended

    // The test case in which the program crashed or was stopped; null if the program ran to its
    // end.
    const TestCase* ended_in() const;
    // Whether the test program ended itself because the tested code computed or waited for too
    // long.
    bool got_no_further() const {
        return ended_in() && (ended_in()->computed > 0 || ended_in()->waited > 0);
    }
    bool was_stopped() const { return result.timed_out || result.too_much || got_no_further(); }
    // Whether it waited for something. A loop computes, however little a busy machine lets it.
    bool waited() const {
        return (ended_in() && ended_in()->waited > 0) ||
               (result.timed_out && 20 * result.cpu_seconds < result.seconds);
    }
    bool crashed() const { return ended_in() || result.signal != 0; }
    // What ended the program, in words for the learner.
    std::string trouble() const;
};

// Which answer an exercise's checkpoints are run on, and how.
struct Cases {
    std::string exercise;  // "03.2"
    bool in_float = false;
    fs::path answer = {};  // the folder of the answer; empty: the learner's
    // Which test cases: all, only the core or only the stars; all but some; or a single one.
    enum class Part { all, core, stars } part = Part::all;
    std::vector<std::string> without = {};
    std::string only = {};
    double timeout = 0;  // in seconds; 0: Course::patience
};
Tested run_cases(const Course& course, const Cases& cases);

// The command that runs the test cases on the answer and shows what fails. With a secret word, it
// prints all that happens instead, one event a line, and each line begins with the word.
std::vector<std::string> command_of(const Course& course, const Cases& cases,
                                    const std::string& secret = "");

// The folder of the learner's answers in this precision, one for each exercise.
fs::path yours_folder(const Course& course, bool in_float);

// The name of an answer's file: "libanswer.03.2.so", which the checkpoint loads, or "answer.00.1"
// if the answer is a whole program.
std::string answer_file(const Exercise& exercise);

}  // namespace companion
