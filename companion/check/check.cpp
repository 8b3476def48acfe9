#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/side_build.hpp>
#include <companion/check/check.hpp>
#include <companion/check/recognition.hpp>
#include <companion/model/state.hpp>
#include <companion/system/process.hpp>
#include <csignal>
#include <map>

namespace companion {
namespace {

// What a program of test cases may print and take: an endless loop can do much in 20 seconds.
constexpr std::size_t most_bytes = std::size_t{16} << 20, most_memory = std::size_t{2} << 30;

std::string target_of(const Exercise& exercise) {
    return "check." + exercise.id;
}

// Builds the targets of these exercises and leaves the compiler's warnings in them. Returns those
// that cannot be built, and the first error of each.
std::map<std::string, std::string> build_all(const Course& course, std::vector<Checked*> some) {
    std::map<std::string, std::string> errors;
    if (some.empty()) return errors;
    std::vector<std::string> targets;
    for (const Checked* checked : some) targets.push_back(target_of(checked->exercise));
    const BuildResult together = build(course, targets);
    for (Checked* checked : some) {
        const Exercise& exercise = checked->exercise;
        checked->warning = first_warning(course, together.output, exercise.files);
        if (together.ok) continue;
        // What is built stays, and what was built alone need not be built again.
        const BuildResult alone =
            some.size() == 1 ? together : build(course, {target_of(exercise)});
        if (alone.ok) continue;
        std::string& error = errors[target_of(exercise)];
        error = first_error(course, alone.output, exercise.files);
        if (error.empty())
            throw app::Failure("the build failed: " +
                               alone.output.substr(0, alone.output.find('\n')));
    }
    return errors;
}

// What all test cases say beside the rt::todo that ended them.
std::string said_by_all(const std::vector<TestCase>& tests) {
    std::string said;
    for (const TestCase& test : tests) {
        if (test.failures.empty() || test.failures.back().messages.empty()) return "";
        const std::string& message = test.failures.back().messages.front();
        if (!said.empty() && message != said) return "";
        said = message;
    }
    return said;
}

// What a program died of; where no signal tells, in the words of its report.
std::string cause_of(const Result& result, const std::string& reported) {
    switch (result.signal) {
        case SIGSEGV:
        case SIGBUS:
            return "it used memory that is not its own (segmentation fault)";
        case SIGFPE:
            return "it divided a whole number by 0";
        case SIGABRT:
            return "it was aborted, as after memory was released twice or written past its end";
        case SIGILL:
            return "it ran into code that is none, as after a forgotten return";
        default:
            return reported.empty() ? how_it_ended(result) : reported;
    }
}

bool is_failing(const TestCase& test) {
    return !test.passed && missing_exercise(test).empty();
}

void run_tests(const Course& course, Checked& checked) {
    // Sanitizers take address space by the terabyte.
    const bool is_sanitized = !cached(course, "RT_SANITIZE").empty();
    const Result result = run_process(
        {.command = {(course.build / "check" / target_of(checked.exercise)).string(), "-r", "events"},
         .folder = course.build,
         .output = Output::errors_hidden,
         .timeout = most_seconds,
         .most_memory = is_sanitized ? 0 : most_memory,
         .most_output = most_bytes});
    checked.tests = read_report(result.output);
    const auto& tests = checked.tests;
    const auto crashed = std::find_if(tests.begin(), tests.end(), [](const TestCase& test) {
        return !test.crash.empty() || !test.ended;
    });
    const auto find_missing = [&] {
        for (const TestCase& test : tests)
            if (!missing_exercise(test).empty()) return missing_exercise(test);
        return std::string{};
    };
    if (result.timed_out || result.too_much) {
        checked.verdict = Verdict::endless;
        checked.trouble = how_it_ended(result);
    } else if (crashed != tests.end() || result.signal != 0) {
        checked.verdict = Verdict::crashed;
        checked.trouble = cause_of(result, crashed != tests.end() ? crashed->crash : "");
    } else if (std::any_of(tests.begin(), tests.end(), is_failing)) {
        checked.verdict = Verdict::failing;
    } else if (const std::string missing = find_missing(); !missing.empty()) {
        const bool is_own = missing == checked.exercise.id;
        checked.verdict = is_own ? Verdict::to_write : Verdict::waiting;
        if (!is_own) checked.missing = missing;
        const int todos = todos_left(course, checked.exercise);
        if (is_own && (todos == 0 || todos == checked.exercise.shipped_todos))
            checked.trouble = said_by_all(tests);
        if (is_own && todos == 0) {
            checked.verdict = Verdict::failing;
            if (checked.trouble.empty())
                checked.trouble =
                    "Nothing of it says rt::todo any more, and still your function is not the one "
                    "that the checkpoints call. Compare its name, namespace and parameters with "
                    "those that were declared, down to each const and &.";
        }
    } else if (tests.empty()) {
        throw app::Failure(target_of(checked.exercise) +
                           " ran no test case: " + how_it_ended(result));
    } else {
        checked.verdict = result.ok() ? Verdict::passed : Verdict::crashed;
        if (!result.ok()) checked.trouble = how_it_ended(result);
    }
}

}  // namespace

std::vector<Checked> check_exercises(const Course& course, const std::vector<Exercise>& exercises) {
    std::vector<Checked> all;
    all.reserve(exercises.size());
    std::vector<std::string> hashes;
    std::vector<Checked*> begun;
    for (const Exercise& exercise : exercises) {
        all.emplace_back().exercise = exercise;
        // Before the build: what is saved during it is not what the verdict is about.
        hashes.push_back(hash_of(course, exercise));
        if (is_begun(course, exercise)) begun.push_back(&all.back());
    }
    const auto errors = build_all(course, begun);
    State before = read_state(course);
    std::map<std::string, Signatures> signatures;  // by chapter
    for (Checked* one : begun) {
        Checked& checked = *one;
        // What was compiled before is not warned of again.
        const Record& known = before[checked.exercise.id];
        if (checked.warning.empty() &&
            known.hash == hashes[static_cast<std::size_t>(one - all.data())])
            checked.warning = known.warning;
        const auto error = errors.find(target_of(checked.exercise));
        if (error != errors.end()) {
            checked.verdict = Verdict::not_compiled;
            checked.trouble = error->second;
            continue;
        }
        run_tests(course, checked);
        if (checked.verdict == Verdict::passed || checked.verdict == Verdict::to_write ||
            checked.verdict == Verdict::waiting)
            continue;
        const Chapter& chapter = checked.exercise.chapter;
        if (!signatures.count(chapter.name))
            signatures[chapter.name] = read_signatures(course, chapter);
        checked.mistakes =
            recognize(signatures[chapter.name], checked.exercise.id, signature_of(checked.tests));
    }
    change_state(course, [&](State& state) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Verdict verdict = all[i].verdict;
            Record& record = state[all[i].exercise.id];
            record.passed = verdict == Verdict::passed;
            // What waits for another exercise says nothing yet of its own answer.
            record.hash = verdict == Verdict::waiting ? "" : hashes[i];
            record.warning = all[i].warning;
        }
    });
    return all;
}

int passed_cases(const Checked& checked) {
    return static_cast<int>(std::count_if(checked.tests.begin(), checked.tests.end(),
                                          [](const TestCase& test) { return test.passed; }));
}

}  // namespace companion
