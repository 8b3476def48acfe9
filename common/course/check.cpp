#include <algorithm>
#include <app/errors.hpp>
#include <course/build.hpp>
#include <course/check.hpp>
#include <course/mistakes.hpp>
#include <course/process.hpp>
#include <course/state.hpp>
#include <map>

namespace course {
namespace {

std::string target_of(const Exercise& exercise) {
    return "check." + exercise.id;
}

// The targets that cannot be built, and the first error of each.
std::map<std::string, std::string> build_errors(const Course& course,
                                                const std::vector<std::string>& targets) {
    std::map<std::string, std::string> errors;
    if (targets.empty() || build(course, targets).ok) return errors;
    for (const std::string& target : targets) {  // what was built is not built again
        const BuildResult alone = build(course, {target});
        if (alone.ok) continue;
        errors[target] = first_error(course, alone.output);
        if (errors[target].empty())
            throw app::Failure("the build failed: " +
                               alone.output.substr(0, alone.output.find('\n')));
    }
    return errors;
}

bool is_failing(const TestCase& test) {
    return !test.passed && missing_exercise(test).empty();
}

void run_tests(const Course& course, Checked& checked) {
    const Result result = run_process(
        {.command = {(course.build / "check" / target_of(checked.exercise)).string(), "-r", "xml"},
         .folder = course.build,
         .output = Output::errors_hidden,
         .timeout = most_seconds});
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
    if (result.timed_out) {
        checked.verdict = Verdict::endless;
        checked.trouble = how_it_ended(result);
    } else if (crashed != tests.end() || result.signal != 0) {
        checked.verdict = Verdict::crashed;
        checked.trouble = crashed != tests.end() && !crashed->crash.empty() ? crashed->crash
                                                                            : how_it_ended(result);
    } else if (std::any_of(tests.begin(), tests.end(), is_failing)) {
        checked.verdict = Verdict::failing;
    } else if (const std::string missing = find_missing(); !missing.empty()) {
        const bool is_own = missing == checked.exercise.id;
        checked.verdict = is_own ? Verdict::to_write : Verdict::waiting;
        if (!is_own) checked.missing = missing;
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
    std::vector<std::string> targets, hashes;
    for (const Exercise& exercise : exercises) {
        all.emplace_back().exercise = exercise;
        // Before the build: what is saved during it is not what the verdict is about.
        hashes.push_back(hash_of(course, exercise));
        if (todos_left(course, exercise) < exercise.shipped_todos)
            targets.push_back(target_of(exercise));
    }
    const auto errors = build_errors(course, targets);
    std::map<std::string, Signatures> signatures;  // by chapter
    for (Checked& checked : all) {
        const std::string target = target_of(checked.exercise);
        if (std::find(targets.begin(), targets.end(), target) == targets.end()) continue;
        if (const auto error = errors.find(target); error != errors.end()) {
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
            recognise(signatures[chapter.name], checked.exercise.id, signature_of(checked.tests));
    }
    change_state(course, [&](State& state) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Verdict verdict = all[i].verdict;
            Record& record = state[all[i].exercise.id];
            record.passed = verdict == Verdict::passed;
            // What waits for another exercise says nothing yet of its own answer.
            record.hash = verdict == Verdict::waiting ? "" : hashes[i];
        }
    });
    return all;
}

int passed_cases(const Checked& checked) {
    return static_cast<int>(std::count_if(checked.tests.begin(), checked.tests.end(),
                                          [](const TestCase& test) { return test.passed; }));
}

}  // namespace course
