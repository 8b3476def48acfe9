#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/check/check.hpp>
#include <companion/check/dropped_fraction.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/parallel.hpp>
#include <ctime>
#include <set>

namespace companion {
namespace {

// The targets of an exercise: the checkpoint, and the learner's answer that it tests.
std::vector<std::string> targets_of(const Exercise& exercise, bool in_float) {
    const std::string id = exercise.id + (in_float ? ".float" : "");
    return {"check." + id, "yours." + id};
}
std::vector<std::string> targets_of(const Checked& checked) {
    return targets_of(checked.exercise, checked.in_float);
}

// Builds the targets of these exercises. Stores the compiler's warnings in each exercise, and its
// errors as the verdict on that exercise in that precision. Another core compiles for float
// meanwhile.
void build_all(const Course& course, const std::vector<Checked*>& some) {
    if (some.empty()) return;
    std::vector<std::string> targets;
    for (const Checked* checked : some) {
        for (std::string& target : targets_of(*checked)) targets.push_back(std::move(target));
        if (!checked->in_float && checked->exercise.chapter.uses_real)
            for (std::string& target : targets_of(checked->exercise, true))
                targets.push_back(std::move(target));
    }
    const BuildResult together = build(course, targets);
    for (Checked* checked : some) {
        const Exercise& exercise = checked->exercise;
        if (!checked->in_float)
            checked->warning = first_warning(course, together.output, exercise.files);
        checked->is_built = together.ok;
        if (together.ok) continue;
        // The parts that were built stay built; an exercise that was built alone need not be built
        // again.
        const BuildResult alone = some.size() == 1 ? together : build(course, targets_of(*checked));
        if (alone.ok) continue;
        const std::string error = first_error(course, alone.output, exercise.files);
        if (error.empty())
            throw app::Failure("the build failed: " +
                               alone.output.substr(0, alone.output.find('\n')));
        checked->verdict = NotCompiled{error};
    }
}

// The message that all test cases show, apart from the rt::todo that ended them.
std::string said_by_all(const std::vector<TestCase>& tests) {
    std::string said;
    for (const TestCase& test : tests) {
        if (test.failures.empty() || test.failures.back().messages.empty()) return "";
        const std::string& message = test.failures.back().messages.front().text;
        if (!said.empty() && message != said) return "";
        said = message;
    }
    return said;
}

bool is_failing(const TestCase& test) {
    return !test.passed && missing_exercise(test).empty();
}

Tested run_cases(const Course& course, const Checked& checked, Cases::Part part = Cases::Part::all,
                 const std::vector<std::string>& without = {}) {
    return run_cases(course, {.exercise = checked.exercise.id,
                              .in_float = checked.in_float,
                              .part = part,
                              .without = without});
}

// The verdict on a run; only the core decides it.
Verdict judge(const Course& course, const Checked& checked, const Tested& tested) {
    const std::vector<TestCase>& tests = tested.tests;
    const bool core_fails = std::any_of(tests.begin(), tests.end(), [](const TestCase& test) {
        return !test.hard && is_failing(test);
    });
    if (tested.was_stopped()) return Endless{tests, tested.trouble(), tested.waited()};
    constexpr int not_started = 127;
    if (tests.empty() && tested.result.exit_code == not_started)
        throw app::Failure("check." + checked.exercise.id +
                           " ran no test case: " + how_it_ended(tested.result));
    if (tested.left_early) return Left{tests};
    if (tested.crashed()) return Crashed{tests, tested.trouble()};
    if (core_fails) return Failing{tests};
    // Another exercise that only a star calls, such as 07.1 in the star of 07.2, can wait.
    std::string missing;
    for (const TestCase& test : tests)
        if (const std::string here = missing_exercise(test);
            missing.empty() && (!test.hard || here == checked.exercise.id))
            missing = here;
    if (missing == checked.exercise.id) {
        const int todos = todos_left(course, checked.exercise);
        const bool has_all = todos == checked.exercise.shipped_todos;
        const std::string said = todos == 0 || has_all ? said_by_all(tests) : "";
        if (todos > 0) return Begun{tests, functions_left(course, checked.exercise), said};
        return Failing{tests, !said.empty()
                                  ? said
                                  : "Your file contains no rt::todo anymore, but the checkpoints "
                                    "do not call your function. Compare its name, namespace "
                                    "and parameters with the declaration, down to each "
                                    "const and &."};
    }
    if (!missing.empty()) return Waiting{missing};
    const bool stars_open =
        std::any_of(tests.begin(), tests.end(), [](const TestCase& test) { return !test.passed; });
    if (tested.result.ok() || stars_open) return Passed{tests};
    return Crashed{tests, how_it_ended(tested.result)};
}

// Notes the stars of a run.
void note_stars(Passed& passed, const Tested& tested) {
    for (const TestCase& test : tested.tests) {
        if (!test.hard) continue;
        ++passed.stars;
        if (test.passed) continue;
        passed.open_stars.push_back({test});
        if (&test == tested.ended_in()) passed.open_stars.back().trouble = tested.trouble();
    }
}

Verdict run_tests(const Course& course, const Checked& checked) {
    Tested tested = run_cases(course, checked);
    Verdict whole = judge(course, checked, tested);
    const TestCase* const last = tested.ended_in();
    if (!last || !last->hard) {
        if (auto* const passed = std::get_if<Passed>(&whole)) note_stars(*passed, tested);
        return whole;
    }
    // First the core runs alone, because it decides. Then each hard case runs, even if an earlier
    // one ends the program.
    Verdict core = judge(course, checked, run_cases(course, checked, Cases::Part::core));
    auto* const passed = std::get_if<Passed>(&core);
    if (!passed) return core;
    passed->tests = tested.tests;
    std::vector<std::string> noted;
    for (; !tested.tests.empty(); tested = run_cases(course, checked, Cases::Part::stars, noted)) {
        note_stars(*passed, tested);
        if (tested.was_stopped()) break;  // waiting once is enough
        for (const TestCase& test : tested.tests)
            if (test.hard) noted.push_back(test.name);
    }
    return core;
}

// Adds the stars that are open only in float.
void add_float_stars(Passed& in_double, const Passed& in_float) {
    auto& open = in_double.open_stars;
    for (OpenStar star : in_float.open_stars) {
        star.in_float = true;
        if (std::none_of(open.begin(), open.end(),
                         [&](const OpenStar& other) { return other.test.name == star.test.name; }))
            open.push_back(std::move(star));
    }
}

// Checks those that pass once more, with rt::Real as float.
void check_in_float(const Course& course, std::vector<Checked>& all) {
    struct Try {
        Checked& in_double;
        Checked in_float;
    };
    std::vector<Try> tries;
    std::vector<Checked*> unbuilt;
    for (Checked& checked : all)
        if (checked.passed() && checked.exercise.chapter.uses_real)
            tries.push_back(
                {checked, {checked.exercise, {}, true, checked.is_built, checked.warning}});
    for (Try& one : tries)
        if (!one.in_float.is_built) unbuilt.push_back(&one.in_float);
    build_all(course, unbuilt);
    in_parallel(tries.size(), [&](std::size_t i) {
        Checked& in_float = tries[i].in_float;
        if (!in_float.is<NotCompiled>()) in_float.verdict = run_tests(course, in_float);
    });
    for (auto& [in_double, in_float] : tries)
        if (in_float.passed())
            add_float_stars(std::get<Passed>(in_double.verdict), *in_float.passed());
        else
            in_double = std::move(in_float);
}

// Records the verdicts on the files that had these hashes, and when each answer first passed. If
// one check finds passing answers in several chapters, they were written some time before, for
// example because the recorded progress was lost: then the time is unknown.
void record(const Course& course, const std::vector<Checked>& all,
            const std::vector<std::string>& hashes) {
    change_state(course, [&](State& state) {
        std::set<std::string> chapters;
        std::vector<Record*> first_passes;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Passed* const passed = all[i].passed();
            Record& record = state.exercises[all[i].exercise.id];
            record.passed = passed;
            // If its files are missing, or if it waits for another exercise, nothing is known of
            // its answer.
            const bool is_known = !all[i].is<NoFile>() && !all[i].is<Waiting>() &&
                                  hash_of(course, all[i].exercise) == hashes[i];
            record.hash = is_known ? hashes[i] : "";
            record.warning = all[i].warning;
            record.stars = passed ? passed->stars : 0;
            record.open_stars = passed ? static_cast<int>(passed->open_stars.size()) : 0;
            if (!passed || record.first_passed != 0) continue;
            first_passes.push_back(&record);
            chapters.insert(all[i].exercise.chapter.name);
        }
        const std::int64_t time = chapters.size() > 1 ? unknown_time : std::time(nullptr);
        for (Record* const record : first_passes) record->first_passed = time;
    });
}

}  // namespace

const std::vector<TestCase>& Checked::tests() const {
    return std::visit(
        [](const auto& kind) -> const std::vector<TestCase>& {
            static const std::vector<TestCase> none;
            if constexpr (requires { kind.tests; })
                return kind.tests;
            else
                return none;
        },
        verdict);
}

int Checked::passed_cases() const {
    return static_cast<int>(std::count_if(tests().begin(), tests().end(),
                                          [](const TestCase& test) { return test.passed; }));
}

std::vector<Checked> check_exercises(const Course& course, const std::vector<Exercise>& exercises,
                                     const std::function<void(const std::vector<Checked>&)>& tell) {
    std::vector<Checked> all;
    all.reserve(exercises.size());
    std::vector<std::string> hashes;
    std::vector<Checked*> begun;
    for (const Exercise& exercise : exercises) {
        Checked& checked = all.emplace_back(Checked{exercise});
        // Before the build: a file saved during the build may or may not be part of what is judged.
        hashes.push_back(hash_of(course, exercise));
        if (const std::string trouble = trouble_with_files(course, exercise); !trouble.empty())
            checked.verdict = NoFile{trouble};
        else if (is_begun(course, exercise))
            begun.push_back(&checked);
    }
    build_all(course, begun);
    const State before = read_state(course);
    in_parallel(begun.size(), [&](std::size_t i) {
        Checked& checked = *begun[i];
        // The compiler does not repeat warnings on code that was compiled before.
        const auto known = before.exercises.find(checked.exercise.id);
        if (checked.warning.empty() && known != before.exercises.end() &&
            known->second.hash == hashes[static_cast<std::size_t>(&checked - all.data())])
            checked.warning = known->second.warning;
        if (!checked.is<NotCompiled>()) checked.verdict = run_tests(course, checked);
        for (const fs::path& file : checked.exercise.files)
            if (const std::string found = dropped_fraction(read_file(course.root / file));
                checked.slip.empty() && !found.empty())
                checked.slip = file.generic_string() + ':' + found;
    });
    tell(all);
    check_in_float(course, all);
    record(course, all, hashes);
    return all;
}

void prepare_check(const Course& course, const Exercise& exercise) {
    std::vector<std::string> targets{"check." + exercise.id};
    if (exercise.chapter.uses_real) targets.push_back(targets[0] + ".float");
    build(course, targets);
}

}  // namespace companion
