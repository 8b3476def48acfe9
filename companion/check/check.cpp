#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/side_build.hpp>
#include <companion/check/check.hpp>
#include <companion/check/recognition.hpp>
#include <companion/model/state.hpp>
#include <companion/system/process.hpp>
#include <csignal>
#include <ctime>
#include <map>
#include <set>

namespace companion {
namespace {

// The most that a test program may print and allocate: an endless loop gets far in 20 seconds.
constexpr std::size_t most_bytes = std::size_t{16} << 20, most_memory = std::size_t{2} << 30;

std::string target_of(const Exercise& exercise, bool in_float = false) {
    return "check." + exercise.id + (in_float ? ".float" : "");
}

// Builds the targets of these exercises in their precision, and stores the compiler's warnings in
// them. Returns the exercises that cannot be built, with the first error of each.
std::map<std::string, std::string> build_all(const Course& course, std::vector<Checked*> some) {
    std::map<std::string, std::string> errors;
    if (some.empty()) return errors;
    std::vector<std::string> targets;
    const auto target_of_one = [](const Checked& one) {
        return target_of(one.exercise, one.in_float);
    };
    for (const Checked* checked : some) targets.push_back(target_of_one(*checked));
    const BuildResult together = build(course, targets);
    for (Checked* checked : some) {
        const Exercise& exercise = checked->exercise;
        if (!checked->in_float)
            checked->warning = first_warning(course, together.output, exercise.files);
        if (together.ok) continue;
        // What was built stays; an exercise that was built alone need not be built again.
        const BuildResult alone =
            some.size() == 1 ? together : build(course, {target_of_one(*checked)});
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

// Why a program crashed, given the test case in which it crashed, if that is known.
std::string cause_of(const Result& result, const TestCase* test) {
    const std::string memory = test ? test->memory : "";
    switch (result.signal) {
        case SIGSEGV:
        case SIGBUS:
            if (memory == "stack")
                return "the stack overflowed: a function never stops calling itself, or a local "
                       "array is too large";
            if (memory == "null")
                return "it dereferenced a null pointer: a pointer to nothing, or an empty "
                       "unique_ptr";
            return "it accessed memory that does not belong to it (segmentation fault): an index "
                   "out of range, the value of an empty std::optional, or a reference to something "
                   "that no longer exists, such as v.back() after v.pop_back()";
        case SIGFPE:
            return "it divided an integer by 0";
        case SIGABRT:
            return "it was aborted: it freed memory twice, or wrote past the end of a block of "
                   "memory, or an exception left a function that must not throw";
        case SIGILL:
            return "it executed invalid code: is a return missing?";
        default:
            return test && !test->crash.empty() ? test->crash : how_it_ended(result);
    }
}

bool is_failing(const TestCase& test) {
    return !test.passed && missing_exercise(test).empty();
}

// One run of an exercise's program of test cases.
struct Tested {
    Result result;
    std::vector<TestCase> tests;

    // The test case in which the program crashed or was stopped; null if it ran to its end.
    const TestCase* ended_in() const {
        const auto found = std::find_if(tests.begin(), tests.end(), [](const TestCase& test) {
            return !test.crash.empty() || !test.ended;
        });
        return found == tests.end() ? nullptr : &*found;
    }
    bool was_stopped() const { return result.timed_out || result.too_much; }
    bool crashed() const { return ended_in() || result.signal != 0; }
    // What ended it.
    std::string trouble() const {
        return was_stopped() ? how_it_ended(result) : cause_of(result, ended_in());
    }
};

// `which` selects test cases in Catch2's notation, "[hard]~[x]"; empty selects all.
Tested run_cases(const Course& course, const Checked& checked, const std::string& which = "") {
    // Sanitizers take address space by the terabyte.
    const bool is_sanitized = !cached(course, "RT_SANITIZE").empty();
    const std::string target = target_of(checked.exercise, checked.in_float);
    Run run{.command = {(course.build / "check" / target).string(), "-r", "events"},
            .folder = course.build,
            .output = Output::errors_hidden,
            .timeout = most_seconds,
            .most_memory = is_sanitized ? 0 : most_memory,
            .most_output = most_bytes};
    if (!which.empty()) run.command.push_back(which);
    Tested tested{run_process(run), {}};
    tested.tests = read_report(tested.result.output);
    return tested;
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
        throw app::Failure(target_of(checked.exercise, checked.in_float) +
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
        checked.first_pass =
            checked.verdict == Verdict::passed && state[checked.exercise.id].first_passed == 0;
        if (checked.first_pass) chapters.insert(checked.exercise.chapter.name);
    }
    const std::int64_t time = chapters.size() > 1 ? unknown_time : std::time(nullptr);
    for (const Checked& checked : all)
        if (checked.first_pass) state[checked.exercise.id].first_passed = time;
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
    std::map<std::string, Signatures> signatures;  // by chapter
    for (Checked* one : begun) {
        Checked& checked = *one;
        // The compiler does not repeat warnings on code that was compiled before.
        const Record& known = before[checked.exercise.id];
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
        if ((checked.verdict == Verdict::passed && checked.open_stars.empty()) ||
            checked.verdict == Verdict::to_write || checked.verdict == Verdict::waiting)
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
            Record& record = state[one.in_double->exercise.id];
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
