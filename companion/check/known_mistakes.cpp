#include <algorithm>
#include <app/files.hpp>
#include <companion/build/remake.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/model/source.hpp>
#include <companion/system/files.hpp>
#include <companion/system/parallel.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>
#include <nlohmann/json.hpp>

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
    const std::string file = answer_file(course, exercise.id);
    in_parallel(answers.size(), [&](std::size_t i) {
        MistakenAnswer& answer = answers[i];
        for (const auto& [name, text] :
             edited_files(course, exercise.chapter.name, answer.mistake)) {
            app::make_folder((answer.folder / name).parent_path());
            app::replace_file(answer.folder / name, text);
        }
        answer.build = remake(answer.folder, answer.folder / file);
    });
    return answers;
}

WhatFails what_fails(const Course& course, const MistakenAnswer& answer) {
    Cases cases = cases_of(answer);
    cases.timeout = course.patience / 2;  // some never end
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

Signatures signatures_of(const Course& course, const Exercise& exercise) {
    const fs::path file = course.build / "signatures" / (exercise.id + ".json");
    const std::string version = version_of(course, exercise);
    if (fs::exists(file)) {
        const auto known = nlohmann::json::parse(read_file(file), nullptr, false);
        if (!known.is_discarded() && known.value("version", "") == version)
            return known.at("mistakes").get<Signatures>();
    }
    const WaitingLine waiting{"comparing with known mistakes; the first time takes a while"};
    const fs::path below = course.build / "mistakes";
    const std::vector<MistakenAnswer> answers = make_mistakes(course, exercise, below);
    std::vector<Signature> found(answers.size());
    in_parallel(answers.size(), [&](std::size_t i) {
        if (answers[i].build.ok) found[i] = what_fails(course, answers[i]).always;
    });
    Signatures signatures;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        signatures[answers[i].mistake.name] = found[i];
        std::error_code held;  // by a virus scanner
        fs::remove_all(answers[i].folder, held);
    }
    app::make_folder(file.parent_path());
    app::replace_file(file,
                      nlohmann::json{{"version", version}, {"mistakes", signatures}}.dump() + '\n');
    return signatures;
}

bool is_refuted(const Mistake& mistake, const std::vector<TestCase>& tests) {
    std::vector<std::string> failed, passed;
    for (const TestCase& test : tests) (test.passed ? passed : failed).push_back(test.name);
    return is_refuted(mistake, failed, passed);
}

LooksLike what_it_looks_like(const Course& course, const Exercise& exercise,
                             const std::vector<TestCase>& tests) {
    const Signature signature = signature_of(tests);
    if (signature.where.empty()) return {};
    std::string code;
    for (const fs::path& one : exercise.files) code += code_of(read_file(course.root / one));
    LooksLike all;
    for (const LookAlikes& names :
         recognize(signatures_of(course, exercise), exercise.id, signature)) {
        std::vector<Mistake> alike;
        for (const std::string& name : names)
            if (Mistake mistake = read_mistake(course, exercise.chapter, name);
                may_be(mistake, code) && !is_refuted(mistake, tests))
                alike.push_back(std::move(mistake));
        if (!alike.empty()) all.push_back(std::move(alike));
    }
    return all;
}

}  // namespace companion
