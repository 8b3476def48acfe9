#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/check/check.hpp>
#include <companion/model/state.hpp>
#include <ctime>
#include <map>
#include <set>

namespace companion {
namespace {

// The checkpoint, and the learner's answer behind it.
std::vector<std::string> targets_of(const Checked& checked) {
    const std::string id = checked.exercise.id + (checked.in_float ? ".float" : "");
    return {"check." + id, "yours." + id};
}

// Builds the targets of these exercises in their precision, and stores the compiler's warnings in
// them. Returns the exercises that cannot be built, with the first error of each.
std::map<std::string, std::string> build_all(const Course& course, std::vector<Checked*> some) {
    std::map<std::string, std::string> errors;
    if (some.empty()) return errors;
    std::vector<std::string> targets;
    for (const Checked* checked : some)
        for (std::string& target : targets_of(*checked)) targets.push_back(std::move(target));
    const BuildResult together = build(course, targets);
    for (Checked* checked : some) {
        const Exercise& exercise = checked->exercise;
        if (!checked->in_float)
            checked->warning = first_warning(course, together.output, exercise.files);
        if (together.ok) continue;
        // What was built stays; an exercise that was built alone need not be built again.
        const BuildResult alone = some.size() == 1 ? together : build(course, targets_of(*checked));
        if (alone.ok) continue;
        std::string& error = errors[exercise.id];
        error = first_error(course, alone.output, exercise.files);
        if (error.empty())
            throw app::Failure("the build failed: " +
                               alone.output.substr(0, alone.output.find('\n')));
    }
    return errors;
}

// The message that all test cases show besides the rt::todo that ended them.
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

bool is_failing(const TestCase& test) {
    return !test.passed && missing_exercise(test).empty();
}

Tested run_cases(const Course& course, const Checked& checked, const std::string& which = "") {
    return run_cases(
        course, {.exercise = checked.exercise.id, .in_float = checked.in_float, .which = which});
}

// The verdict on a run, which speaks of the core alone.
void judge(const Course& course, Checked& checked, const Tested& tested) {
    const auto& tests = tested.tests;
    checked.tests = tests;
    const auto fails = [&](bool hard) {
        return std::any_of(tests.begin(), tests.end(), [&](const TestCase& test) {
            return test.hard == hard && is_failing(test);
        });
    };
    const auto find_missing = [&] {
        for (const TestCase& test : tests)
            if (!missing_exercise(test).empty()) return missing_exercise(test);
        return std::string{};
    };
    if (tested.was_stopped() || tested.crashed()) {
        checked.verdict = tested.was_stopped() ? Verdict::endless : Verdict::crashed;
        checked.trouble = tested.trouble();
    } else if (fails(false)) {
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
                    "No rt::todo is left in it, but the checkpoints do not call your function. "
                    "Compare its name, namespace and parameters with the declaration, down to "
                    "each const and &.";
        }
    } else if (tests.empty()) {
        throw app::Failure("check." + checked.exercise.id +
                           " ran no test case: " + how_it_ended(tested.result));
    } else {
        checked.verdict = tested.result.ok() || fails(true) ? Verdict::passed : Verdict::crashed;
        if (checked.verdict != Verdict::passed) checked.trouble = how_it_ended(tested.result);
    }
}

// Notes the stars of a run.
void note_stars(Checked& checked, const Tested& tested) {
    for (const TestCase& test : tested.tests) {
        if (!test.hard) continue;
        ++checked.stars;
        if (test.passed) continue;
        checked.open_stars.push_back({test});
        if (&test == tested.ended_in()) checked.open_stars.back().trouble = tested.trouble();
    }
}

void run_tests(const Course& course, Checked& checked) {
    Tested tested = run_cases(course, checked);
    judge(course, checked, tested);
    if (const TestCase* const last = tested.ended_in(); last && last->hard) {
        // The core alone; then each hard case runs, even if an earlier one ends the program.
        Checked core = checked;
        core.trouble.clear();
        judge(course, core, run_cases(course, checked, "~[hard]"));
        if (core.verdict != Verdict::passed) {
            if (core.verdict == Verdict::to_write || core.verdict == Verdict::waiting)
                checked = core;
            return;
        }
        core.tests = checked.tests;
        checked = core;
        std::string others = "[hard]";
        for (; !tested.tests.empty(); tested = run_cases(course, checked, others)) {
            note_stars(checked, tested);
            if (tested.was_stopped()) break;  // waiting for one timeout is enough
            for (const TestCase& test : tested.tests)
                if (test.hard) others += "~\"" + test.name + '"';
        }
    } else if (checked.verdict == Verdict::passed) {
        note_stars(checked, tested);
    }
}

// Notes when answers passed first. Where one check finds right ones in several chapters, they were
// written some time before it, as after the remembered progress was lost.
void note_first_passes(State& state, std::vector<Checked>& all) {
    std::set<std::string> chapters;
    for (Checked& checked : all) {
        checked.first_pass = checked.verdict == Verdict::passed &&
                             state.exercises[checked.exercise.id].first_passed == 0;
        if (checked.first_pass) chapters.insert(checked.exercise.chapter.name);
    }
    const std::int64_t time = chapters.size() > 1 ? unknown_time : std::time(nullptr);
    for (const Checked& checked : all)
        if (checked.first_pass) state.exercises[checked.exercise.id].first_passed = time;
}

}  // namespace

std::vector<Checked> check_exercises(const Course& course, const std::vector<Exercise>& exercises) {
    std::vector<Checked> all;
    all.reserve(exercises.size());
    std::vector<std::string> hashes;
    std::vector<Checked*> begun;
    for (const Exercise& exercise : exercises) {
        all.emplace_back().exercise = exercise;
        // Before the build: a file saved during the build may or may not be part of what is judged.
        hashes.push_back(hash_of(course, exercise));
        if (all.back().trouble = trouble_with_files(course, exercise); !all.back().trouble.empty())
            all.back().verdict = Verdict::no_file;
        else if (is_begun(course, exercise))
            begun.push_back(&all.back());
    }
    const auto errors = build_all(course, begun);
    State before = read_state(course);
    for (Checked* one : begun) {
        Checked& checked = *one;
        // The compiler does not repeat warnings on code that was compiled before.
        const Record& known = before.exercises[checked.exercise.id];
        if (checked.warning.empty() &&
            known.hash == hashes[static_cast<std::size_t>(one - all.data())])
            checked.warning = known.warning;
        const auto error = errors.find(checked.exercise.id);
        if (error != errors.end()) {
            checked.verdict = Verdict::not_compiled;
            checked.trouble = error->second;
            continue;
        }
        run_tests(course, checked);
        if (checked.verdict == Verdict::to_write)
            checked.left = functions_left(course, checked.exercise);
    }
    change_state(course, [&](State& state) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Verdict verdict = all[i].verdict;
            Record& record = state.exercises[all[i].exercise.id];
            record.passed = verdict == Verdict::passed;
            // If it waits for another exercise, nothing is known yet of its own answer.
            const bool is_known =
                verdict != Verdict::waiting && hash_of(course, all[i].exercise) == hashes[i];
            record.hash = is_known ? hashes[i] : "";
            record.warning = all[i].warning;
            record.stars = all[i].stars;
            record.open_stars = static_cast<int>(all[i].open_stars.size());
        }
        note_first_passes(state, all);
    });
    return all;
}

int check_in_float(const Course& course, std::vector<Checked>& all) {
    struct Try {
        Checked* in_double;
        Checked in_float;
    };
    std::vector<Try> tries;
    for (Checked& checked : all)
        if (checked.verdict == Verdict::passed && checked.exercise.chapter.uses_real) {
            Checked& in_float = tries.emplace_back(Try{&checked, {}}).in_float;
            in_float.exercise = checked.exercise;
            in_float.warning = checked.warning;
            in_float.first_pass = checked.first_pass;
            in_float.in_float = true;
        }
    std::vector<Checked*> targets;
    for (Try& one : tries) targets.push_back(&one.in_float);
    const auto errors = build_all(course, targets);
    for (auto& [in_double, in_float] : tries) {
        const auto error = errors.find(in_float.exercise.id);
        if (error == errors.end()) {
            run_tests(course, in_float);
        } else {
            in_float.verdict = Verdict::not_compiled;
            in_float.trouble = error->second;
        }
        if (in_float.verdict != Verdict::passed) {
            *in_double = std::move(in_float);
            continue;
        }
        auto& open = in_double->open_stars;
        for (OpenStar& star : in_float.open_stars) {
            star.in_float = true;
            if (std::none_of(open.begin(), open.end(), [&](const OpenStar& other) {
                    return other.test.name == star.test.name;
                }))
                open.push_back(std::move(star));
        }
    }
    change_state(course, [&](State& state) {
        for (const Try& one : tries) {
            Record& record = state.exercises[one.in_double->exercise.id];
            if (record.hash != hash_of(course, one.in_double->exercise)) record.hash.clear();
            if (one.in_double->in_float) {
                record.passed = false;
                if (one.in_double->first_pass) record.first_passed = 0;
            }
            record.open_stars = static_cast<int>(one.in_double->open_stars.size());
        }
    });
    return static_cast<int>(tries.size());
}

int passed_cases(const Checked& checked) {
    return static_cast<int>(std::count_if(checked.tests.begin(), checked.tests.end(),
                                          [](const TestCase& test) { return test.passed; }));
}

}  // namespace companion
