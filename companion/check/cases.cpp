#include <algorithm>
#include <companion/build/side_build.hpp>
#include <companion/check/cases.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/secret.hpp>
#include <cstdio>

namespace companion {
namespace {

// The most that a test program may print and allocate: an endless loop can do a lot in 20 seconds.
constexpr std::size_t most_bytes = std::size_t{16} << 20, most_memory = std::size_t{2} << 30;

// Why a program crashed, given the test case in which it crashed, if that is known.
std::string cause_of(const Result& result, const TestCase* test, bool may_have_threads) {
    const std::string memory = test ? test->memory : "";
    switch (crash_of(result.signal)) {
        case Crash::memory:
            if (memory == "stack")
                return "the stack overflowed: a function calls itself without end, or a local "
                       "array is too large";
            if (memory == "null") return "it dereferenced a null pointer or an empty unique_ptr";
            return "it accessed memory that does not belong to it (segmentation fault): an index "
                   "out of range, the value of an empty std::optional, or a reference to something "
                   "that no longer exists, such as v.back() after v.pop_back()";
        case Crash::division:
            return "it divided an integer by 0";
        case Crash::aborted:
            // The library's own words, if it found the fault.
            if (result.output.find("_M_is_engaged()' failed") != std::string::npos)
                return "it used the value of an empty std::optional: before you write `*name` or "
                       "`name->`, test it with `if (name)`";
            if (result.output.find("pointer()' failed") != std::string::npos)
                return "it dereferenced an empty unique_ptr";
            if (result.output.find("size()' failed") != std::string::npos)
                return "an index is out of range: the first is 0, and the last is size() - 1";
            return std::string{
                       "it was aborted: an index is out of range, an empty std::optional "
                       "has no value, memory was freed twice, "} +
                   (may_have_threads ? "a std::thread was destroyed before it was joined, or an "
                                       "exception left a thread or a function that must not throw"
                                     : "or an exception left a function that must not throw");
        case Crash::invalid_code:
            return "it executed invalid code: is a return statement missing?";
        case Crash::none:
            return test && !test->crash.empty() ? test->crash : "the code ended the program";
        default:
            return test && !test->crash.empty() ? test->crash : how_it_ended(result);
    }
}

// The test cases in Catch2's notation; empty if all are meant.
std::string in_catch_notation(const Cases& cases) {
    if (!cases.only.empty()) return cases.only;
    std::string words = cases.part == Cases::Part::core    ? "~[hard]"
                        : cases.part == Cases::Part::stars ? "[hard]"
                                                           : "";
    for (const std::string& name : cases.without) words += "~\"" + name + '"';
    return words;
}

bool asks_for(const Cases& cases, const TestCase& test) {
    if (!cases.only.empty()) return test.name == cases.only;
    return (cases.part == Cases::Part::all || test.hard == (cases.part == Cases::Part::stars)) &&
           !std::count(cases.without.begin(), cases.without.end(), test.name);
}

// Whether each test case that was asked for ran to its end, once.
bool is_complete(const Cases& cases, const Report& report) {
    if (report.exited || report.compiled.empty()) return false;
    return std::all_of(report.compiled.begin(), report.compiled.end(),
                       [&](const TestCase& compiled) {
                           return std::count_if(report.tests.begin(), report.tests.end(),
                                                [&](const TestCase& test) {
                                                    return test.name == compiled.name && test.ended;
                                                }) == asks_for(cases, compiled);
                       });
}

}  // namespace

bool knows_threads(const std::string& exercise) {
    return exercise >= "06";
}

const TestCase* Tested::ended_in() const {
    const auto found = std::find_if(tests.begin(), tests.end(),
                                    [](const TestCase& test) { return test.broke_off(); });
    return found == tests.end() ? nullptr : &*found;
}

std::string Tested::trouble() const {
    if (got_no_further()) {
        const auto [what, seconds] = ended_in()->waited > 0
                                         ? std::pair{"waited", ended_in()->waited}
                                         : std::pair{"computed", ended_in()->computed};
        return std::string{"it "} + what + " for " + std::to_string(seconds) +
               " s without finishing";
    }
    return was_stopped() ? how_it_ended(result)
                         : cause_of(result, ended_in(), knows_threads(exercise));
}

fs::path yours_folder(const Course& course, bool in_float) {
    return course.build / "answers/yours" / (in_float ? "float" : "double");
}

std::string answer_file(const Exercise& exercise) {
    const bool is_library = exercise.files.front().parent_path().filename() == "rt";
    return (is_library ? library_name : program_name)("answer." + exercise.id);
}

std::vector<std::string> command_of(const Course& course, const Cases& cases,
                                    const std::string& secret) {
    const fs::path answer =
        cases.answer.empty() ? yours_folder(course, cases.in_float) : cases.answer;
    const std::string program = "check." + cases.exercise + (cases.in_float ? ".float" : "");
    std::vector<std::string> command{"env", libraries_in(answer),
                                     "COURSE_ANSWER=" + answer.string(),
                                     (course.build / "check" / program_name(program)).string()};
    if (!secret.empty()) {
        command.insert(command.begin() + 1, "COURSE_EVENTS=" + secret);
        command.insert(command.end(), {"-r", "events"});
    }
    if (const std::string which = in_catch_notation(cases); !which.empty())
        command.push_back(which);
    return command;
}

Tested run_cases(const Course& course, const Cases& cases) {
    // Sanitizers reserve terabytes of address space.
    const bool is_sanitized = !cached(course, "RT_SANITIZE").empty();
    const std::string secret = new_secret();
    Tested tested{cases.exercise,
                  run_process({.command = command_of(course, cases, secret),
                               .folder = course.build,
                               .output = Output::captured,
                               .has_events = true,
                               .timeout = cases.timeout > 0 ? cases.timeout : course.patience,
                               .most_memory = is_sanitized ? 0 : most_memory,
                               .most_output = most_bytes}),
                  {}};
    Report report = read_report(tested.result.events, secret);
    tested.left_early =
        !tested.was_stopped() && tested.result.signal == 0 && !is_complete(cases, report);
    tested.tests = std::move(report.tests);
    return tested;
}

}  // namespace companion
