#include <algorithm>
#include <app/files.hpp>
#include <companion/build/remake.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/check/likely.hpp>
#include <companion/model/source.hpp>
#include <companion/model/state.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/files.hpp>
#include <companion/system/parallel.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

namespace companion {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Signature, where, what)

namespace {

std::vector<Mistake> mistakes_of(const Course& course, const Exercise& exercise) {
    const fs::path file =
        course.root / "tests/mistakes" / exercise.chapter.name / (exercise.id + ".md");
    return fs::exists(file) ? read_mistakes(file) : std::vector<Mistake>{};
}

// A hash of everything on which the failures depend.
std::string version_of(const Course& course, const Exercise& exercise) {
    std::string bytes;
    for (const Mistake& mistake : mistakes_of(course, exercise))
        for (const Edit& edit : mistake.edits)
            bytes += mistake.name + edit.file + edit.before + edit.after;
    for (const char* const kind : {"solutions", "tests/plain"})
        for (const fs::path& file : source_files(course.root / kind / exercise.chapter.name))
            bytes += read_file(file);
    const auto checkpoint =
        last_written(course.build / "check" / program_name("check." + exercise.id));
    return hash_of(bytes + std::to_string(checkpoint.value_or(0)));
}

Cases cases_of(const MistakenAnswer& answer) {
    return {.exercise = answer.mistake.name.substr(0, answer.mistake.name.find('_')),
            .answer = answer.folder};
}

fs::path signatures_file(const Course& course, const Exercise& exercise) {
    return course.build / "signatures" / (exercise.id + ".json");
}

// What is known so far.
Signatures known_signatures(const Course& course, const Exercise& exercise,
                            const std::string& version) {
    const fs::path file = signatures_file(course, exercise);
    if (!fs::exists(file)) return {};
    const auto known = nlohmann::json::parse(read_file(file), nullptr, false);
    if (!known.is_object() || known.value("version", "") != version) return {};
    return known.at("mistakes").get<Signatures>();
}

// Makes a mistake in the folder that is its own.
void make(const Course& course, const Exercise& exercise, const Remake& remake,
          MistakenAnswer& answer) {
    for (const auto& [name, text] : edited_files(course, exercise.chapter.name, answer.mistake)) {
        app::make_folder((answer.folder / name).parent_path());
        app::replace_file(answer.folder / name, text);
    }
    answer.build = remake(answer.folder, answer.folder / answer_file(exercise));
}

// The mistakes that the learner's answer can contain, the likeliest first.
std::vector<Mistake> likely_in_answer(const Course& course, const Exercise& exercise,
                                      const std::vector<TestCase>& tests) {
    std::string code;
    for (const fs::path& one : exercise.files) code += code_of(read_file(course.root / one));
    return likely_mistakes(mistakes_of(course, exercise), tests, code);
}

void keep_common(std::set<std::string>& kept, const std::set<std::string>& other) {
    std::erase_if(kept, [&](const std::string& hash) { return !other.count(hash); });
}

}  // namespace

std::vector<MistakenAnswer> make_mistakes(const Course& course, const Exercise& exercise,
                                          const fs::path& below, const std::string& remark) {
    std::vector<MistakenAnswer> answers;
    for (Mistake& mistake : mistakes_of(course, exercise)) {
        if (!remark.empty() && !mistake.remarks.count(remark)) continue;
        const fs::path folder = below / mistake.name;
        answers.push_back({std::move(mistake), folder, {}});
    }
    if (answers.empty()) return {};
    const Remake remake{course, "answer." + exercise.id};
    in_parallel(answers.size(), [&](std::size_t i) { make(course, exercise, remake, answers[i]); });
    return answers;
}

WhatFails what_fails(const Course& course, const MistakenAnswer& answer, double patience) {
    Cases cases = cases_of(answer);
    cases.timeout = patience;  // some never end
    // A plain answer leaves the stars open, and a core that fails says nothing of them.
    if (answer.mistake.remarks.count("edits")) cases.part = Cases::Part::core;
    const Tested first = run_cases(course, cases);
    WhatFails fails{.tests = first.tests, .always = signature_of(first.tests)};
    if (first.got_no_further()) return fails;  // nor would it a second time
    // What passes is not in what fails every time; but what comes before a failure may be its
    // cause.
    for (auto test = first.tests.rbegin(); test != first.tests.rend() && test->passed; ++test)
        cases.without.push_back(test->name);
    const auto again = [&] { return signature_of(run_cases(course, cases).tests); };
    const Signature second = again();
    if (second == fails.always) return fails;
    fails.by_chance = true;
    for (const Signature& other : {second, again()}) keep_common(fails.always.where, other.where);
    fails.always.what.clear();  // values that changed once may change again
    return fails;
}

bool is_caught(const Course& course, const MistakenAnswer& answer,
               const std::vector<TestCase>& tests) {
    const auto is_caught_in = [&](const std::vector<TestCase>& all) {
        return std::any_of(all.begin(), all.end(), [&](const TestCase& test) {
            return test.name == answer.mistake.caught_by && !test.broke_off() &&
                   !test.failures.empty();
        });
    };
    if (is_caught_in(tests)) return true;
    // The mistake may end the program before the test case that catches it begins.
    Cases cases = cases_of(answer);
    cases.only = answer.mistake.caught_by;
    cases.timeout = 60;
    return is_caught_in(run_cases(course, cases).tests);
}

void find_signatures(const Course& course, const Exercise& exercise,
                     const std::vector<Mistake>& mistakes, double patience,
                     const std::function<void(const Mistake&, const Signature&)>& found,
                     const std::function<bool()>& is_over) {
    if (mistakes.empty()) return;
    const std::string version = version_of(course, exercise);
    const Remake remake{course, "answer." + exercise.id};
    const FileLock one_at_a_time{private_folder(course) / "mistakes.lock"};
    Signatures known = known_signatures(course, exercise, version);
    std::mutex noting;
    in_parallel(mistakes.size(), [&](std::size_t i) {
        if (is_over()) return;
        const Mistake& mistake = mistakes[i];
        std::unique_lock lock{noting};
        if (!known.count(mistake.name)) {  // nor has another process found it out meanwhile
            lock.unlock();
            MistakenAnswer answer{mistake, course.build / "mistakes" / mistake.name, {}};
            make(course, exercise, remake, answer);
            const Signature signature =
                answer.build.ok ? what_fails(course, answer, patience).always : Signature{};
            std::error_code held;  // by a virus scanner
            fs::remove_all(answer.folder, held);
            if (is_over()) return;  // it may have been ended early
            lock.lock();
            known[mistake.name] = signature;
            const fs::path file = signatures_file(course, exercise);
            app::make_folder(file.parent_path());
            const nlohmann::json all{{"version", version}, {"mistakes", known}};
            app::replace_file(file, all.dump() + '\n');
        }
        found(mistake, known[mistake.name]);
    });
}

std::vector<Mistake> mistakes_without_signature(const Course& course, const Exercise& exercise) {
    const Signatures known = known_signatures(course, exercise, version_of(course, exercise));
    std::vector<Mistake> all = mistakes_of(course, exercise);
    std::erase_if(all, [&](const Mistake& mistake) { return known.count(mistake.name) > 0; });
    return all;
}

std::string most_telling(const Course& course, const Exercise& exercise,
                         const std::vector<TestCase>& tests) {
    const Signature signature = signature_of(tests);
    if (signature.where.empty()) return "";
    const Signatures known = known_signatures(course, exercise, version_of(course, exercise));
    for (const Mistake& mistake : likely_in_answer(course, exercise, tests))
        if (const auto found = known.find(mistake.name);
            found != known.end() && found->second == signature)
            return mistake.caught_by;
    return "";
}

void tell_what_it_looks_like(const Course& course, const Exercise& exercise,
                             const std::vector<TestCase>& tests,
                             const std::function<void(const Mistake&, Joins)>& tell,
                             const std::function<bool()>& is_over) {
    const Signature signature = signature_of(tests);
    if (signature.where.empty()) return;
    const std::vector<Mistake> likely = likely_in_answer(course, exercise, tests);
    const Signatures before = known_signatures(course, exercise, version_of(course, exercise));
    Signatures known;  // of the likely ones
    std::set<std::string> told;
    const auto tell_once = [&](const Mistake& mistake, Joins joins) {
        if (told.insert(mistake.name).second)
            tell(mistake, told.size() == 1 ? Joins::first : joins);
    };
    std::vector<Mistake> unknown;
    for (const Mistake& mistake : likely)
        if (const auto found = before.find(mistake.name); found == before.end())
            unknown.push_back(mistake);
        else if ((known[mistake.name] = found->second) == signature)
            tell_once(mistake, Joins::as_or);
    if (!unknown.empty()) {
        const char* const what = "comparing with known mistakes; the first time takes a while";
        std::optional<WaitingLine> waiting{what};
        find_signatures(
            course, exercise, unknown, course.patience / 2,
            [&](const Mistake& mistake, const Signature& found) {
                known[mistake.name] = found;
                if (!(found == signature) || is_over()) return;
                waiting.reset();
                tell_once(mistake, Joins::as_or);
                waiting.emplace(what);
            },
            is_over);
    }
    if (is_over() || !told.empty()) return;
    for (const LookAlikes& names : recognize(known, exercise.id, signature))
        for (const std::string& name : names) {
            const auto mistake = std::find_if(likely.begin(), likely.end(),
                                              [&](const Mistake& one) { return one.name == name; });
            tell_once(*mistake, &name == &names[0] ? Joins::as_and : Joins::as_or);
        }
}

}  // namespace companion
