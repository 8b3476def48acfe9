// Makes the known mistakes, in a build that has their exercises' checkpoints, and says what becomes
// of them.
//
//   mistake_tool check NN.k          The test case that should catch a mistake fails. What fails is
//                                    recognized: as this mistake, or as one that looks the same.
//   mistake_tool certify NN_topic    `course certify` finds it ("certificate fails").
//   mistake_tool pictures NN_topic   `course compare` sees another picture ("changes picture").
//   mistake_tool compare NN_topic    These are its words ("compare says").
//   mistake_tool memory NN_topic     The address sanitizer says so ("address sanitizer reports").
//   mistake_tool races NN_topic      The thread sanitizer reports a data race ("data race in").
//   mistake_tool program NAMES TARGET FILE   Builds a program of the build with mistakes, with +
//   between
//                                    their names, for tests/pictures.py. For a name, there may be a
//                                    folder with changed headers.
//   mistake_tool trail FILE          What --follow says of a trail, for tests/follow.py.

#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/build/remake.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/check/likely.hpp>
#include <companion/check/sanitized.hpp>
#include <companion/follow/trail.hpp>
#include <companion/model/source.hpp>
#include <companion/system/files.hpp>
#include <companion/system/parallel.hpp>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <regex>
#include <sstream>

using namespace companion;

namespace {

// The build is this tool's own, or the one that the environment names.
Course course_of_build() {
    Course found = this_course();
    if (const char* const build = std::getenv("COURSE_BUILD")) found.build = build;
    return found;
}

const Course course = course_of_build();
const fs::path below = course.build / "mistakes";

// One mistake's line: what is wrong, or empty.
struct Outcome {
    std::string words, wrong;
};

int report(const std::string& what, const std::vector<MistakenAnswer>& answers,
           const std::vector<Outcome>& outcomes) {
    long failed = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        failed += !outcomes[i].wrong.empty();
        std::printf("%s%s: %s\n", outcomes[i].wrong.empty() ? "" : "FAILS ",
                    answers[i].mistake.name.c_str(),
                    (outcomes[i].wrong.empty() ? outcomes[i].words : outcomes[i].wrong).c_str());
    }
    std::printf("%s: %zu mistakes, %ld fail\n", what.c_str(), answers.size(), failed);
    return failed || answers.empty() ? app::could_not : app::done;
}

// Whether a mistake is recognized by what fails in it, as itself or as one that looks the same.
// `likely` are those that `check` tries.
Outcome recognition(const Mistake& mistake, const Signatures& all,
                    const std::vector<Mistake>& likely, const WhatFails& fails) {
    Signatures known;
    for (const Mistake& one : likely) known[one.name] = all.at(one.name);
    const auto found =
        recognize(known, mistake.name.substr(0, mistake.name.find('_')), signature_of(fails.tests));
    if (found.size() == 1 &&
        std::find(found[0].begin(), found[0].end(), mistake.name) != found[0].end())
        return {
            found[0].size() == 1 ? "caught, recognized" : "caught, recognized, and others like it",
            ""};
    const std::string taken =
        "caught, taken for " + (found.empty() ? "no known mistake" : found[0][0]);
    return fails.by_chance ? Outcome{taken + ", as it fails by chance", ""} : Outcome{"", taken};
}

// The code of the answer that contains the mistake, without comments.
std::string code_of_answer(const Exercise& exercise, const MistakenAnswer& answer) {
    const fs::path solution = course.root / "solutions" / exercise.chapter.name;
    std::string code;
    for (const fs::path& file : exercise.files) {
        const fs::path name =
            file.lexically_relative(fs::path{"exercises"} / exercise.chapter.name);
        const bool is_edited = fs::exists(answer.folder / name);
        code += code_of(read_file((is_edited ? answer.folder : solution) / name));
    }
    return code;
}

// Why `check` would not name this mistake, though it is the one that was made; or empty.
std::string no_guess(const std::string& code, const MistakenAnswer& answer,
                     const WhatFails& fails) {
    if (!may_be(answer.mistake, code)) return "its own code lacks what it needs to be a guess";
    if (!fails.by_chance && is_refuted(answer.mistake, fails.tests))
        return "what fails in it speaks against it";
    return "";
}

// ", named by try 2 of 5": which of the mistakes that `check` tries on this answer is the first in
// which the same fails.
std::string tries(const std::vector<Mistake>& likely, const Signatures& known,
                  const WhatFails& fails) {
    const auto right = std::find_if(likely.begin(), likely.end(), [&](const Mistake& mistake) {
        return known.at(mistake.name) == fails.always;
    });
    if (right == likely.end()) return "";
    return ", named by try " + std::to_string(right - likely.begin() + 1) + " of " +
           std::to_string(likely.size());
}

int check(const std::string& id) {
    const Exercise exercise = find_exercise(course, id);
    const std::vector<MistakenAnswer> answers = make_mistakes(course, exercise, below);
    Signatures known;
    std::vector<WhatFails> fails(answers.size());
    in_parallel(answers.size(), [&](std::size_t i) {
        if (answers[i].build.ok) fails[i] = what_fails(course, answers[i], course.patience / 2);
    });
    for (std::size_t i = 0; i < answers.size(); ++i)
        known[answers[i].mistake.name] = fails[i].always;
    std::vector<Mistake> all;
    for (const MistakenAnswer& answer : answers) all.push_back(answer.mistake);
    std::vector<Outcome> outcomes(answers.size());
    in_parallel(answers.size(), [&](std::size_t i) {
        const Mistake& mistake = answers[i].mistake;
        Outcome& outcome = outcomes[i];
        const std::string code = code_of_answer(exercise, answers[i]);
        const std::vector<Mistake> likely = likely_mistakes(all, fails[i].tests, code);
        if (!answers[i].build.ok)
            outcome.wrong = "does not compile:\n" + first_error(course, answers[i].build.output);
        else if (!is_caught(course, answers[i], fails[i].tests))
            outcome.wrong = "NOT CAUGHT by '" + mistake.caught_by + '\'';
        else
            outcome = recognition(mistake, known, likely, fails[i]);
        if (outcome.wrong.empty()) outcome.wrong = no_guess(code, answers[i], fails[i]);
        outcome.words += tries(likely, known, fails[i]);
    });
    for (const MistakenAnswer& answer : answers) fs::remove_all(answer.folder);
    return report(id, answers, outcomes);
}

// The mistakes of a chapter with this remark, each compiled into a program of the build and judged.
int try_in_program(const std::string& chapter, const std::string& remark, const std::string& target,
                   const std::function<Outcome(const MistakenAnswer&, const fs::path&)>& judge) {
    std::vector<MistakenAnswer> answers;
    for (Mistake& mistake : read_mistakes(course, Chapter{.name = chapter}))
        if (mistake.remarks.count(remark))
            answers.push_back({mistake, below / (remark + ' ' + mistake.name), {}});
    std::vector<Outcome> outcomes(answers.size());
    if (answers.empty()) {
        std::printf("%s: no mistake says '%s'\n", chapter.c_str(), remark.c_str());
        return app::done;
    }
    const Remake remake{course, target};
    in_parallel(answers.size(), [&](std::size_t i) {
        const fs::path folder = answers[i].folder, program = folder / "program";
        for (const auto& [name, text] : edited_files(course, chapter, answers[i].mistake)) {
            app::make_folder((folder / name).parent_path());
            app::replace_file(folder / name, text);
        }
        const BuildResult built = remake(folder, program);
        if (built.ok)
            outcomes[i] = judge(answers[i], program);
        else
            outcomes[i].wrong = "does not compile:\n" + first_error(course, built.output);
        fs::remove_all(folder);
    });
    return report(chapter + ", " + remark, answers, outcomes);
}

Outcome expect(const std::string& output, const std::string& pattern) {
    if (std::regex_search(output, std::regex{pattern})) return {"seen", ""};
    return {"", "expected '" + pattern + "' in:\n" + output.substr(0, 2000)};
}

int certify(const std::string& chapter) {
    return try_in_program(
        chapter, "certificate fails", "certify." + chapter + "_solution",
        [](const MistakenAnswer& answer, const fs::path& program) {
            const std::string id = answer.mistake.name.substr(0, answer.mistake.name.find('_'));
            return expect(run_process({.command = {program.string(), "--no-timing"}}).output,
                          "FAILS\t" + id);
        });
}

// How the picture of a program with a mistake differs from the solution's.
Result difference(const std::string& chapter, const fs::path& program) {
    return run_process(
        {.command = {course.program("compare_programs").string(), "differ", program.string(),
                     course.program(chapter + "_solution").string()}});
}

int pictures(const std::string& chapter) {
    return try_in_program(chapter, "changes picture", chapter + "_solution",
                          [&](const MistakenAnswer&, const fs::path& program) -> Outcome {
                              const Result seen = difference(chapter, program);
                              return seen.ok() ? Outcome{"seen", ""} : Outcome{"", seen.output};
                          });
}

int what_compare_says(const std::string& chapter) {
    const std::string remark = "compare says";
    return try_in_program(chapter, remark, chapter + "_solution",
                          [&](const MistakenAnswer& answer, const fs::path& program) -> Outcome {
                              const Result seen = difference(chapter, program);
                              if (!seen.ok()) return {"", seen.output};
                              return expect(seen.output, answer.mistake.remarks.at(remark));
                          });
}

int memory(const std::string& chapter) {
    const std::string remark = "address sanitizer reports";
    return try_in_program(chapter, remark, chapter + "_memory",
                          [&](const MistakenAnswer& answer, const fs::path& program) {
                              return expect(run_process({.command = {program.string()}}).output,
                                            answer.mistake.remarks.at(remark));
                          });
}

int races(const std::string& chapter) {
    const std::string remark = "data race in";
    std::vector<MistakenAnswer> answers;
    std::vector<Outcome> outcomes;
    for (const Exercise& exercise : exercises(course, Chapter{.name = chapter, .hints = {}}))
        for (MistakenAnswer& answer : make_mistakes(course, exercise, below, remark)) {
            const Cases cases{.exercise = exercise.id,
                              .answer = answer.folder,
                              .only = answer.mistake.remarks.at(remark)};
            std::vector<std::string> command = at_fixed_addresses();
            for (std::string& word : command_of(course, cases)) command.push_back(std::move(word));
            outcomes.push_back(answer.build.ok ? expect(run_process({.command = command}).output,
                                                        "WARNING: ThreadSanitizer: data race")
                                               : Outcome{"", answer.build.output});
            answers.push_back(std::move(answer));
        }
    return report(chapter + ", " + remark, answers, outcomes);
}

int program(const std::string& names, const std::string& target, const fs::path& file) {
    const fs::path folder = below / ("program " + file.filename().string());
    fs::remove_all(folder);
    app::make_folder(folder);
    std::istringstream list{names};
    for (std::string name; std::getline(list, name, '+');) {
        if (fs::is_directory(name)) {
            fs::copy(name, folder, fs::copy_options::recursive);
            continue;
        }
        const Chapter chapter = find_chapter(course, name.substr(0, 2));
        const Mistake mistake = read_mistake(course, chapter, name);
        for (const auto& [header, text] : edited_files(course, chapter.name, mistake)) {
            app::make_folder((folder / header).parent_path());
            app::replace_file(folder / header, text);
        }
    }
    const BuildResult built = Remake{course, target}(folder, folder / "program");
    if (!built.ok) throw app::Failure(names + " does not compile:\n" + built.output);
    fs::copy_file(folder / "program", file, fs::copy_options::overwrite_existing);
    fs::remove_all(folder);
    return app::done;
}

int run(const std::vector<std::string>& words) {
    if (words.size() == 4 && words[0] == "program") return program(words[1], words[2], words[3]);
    if (words.size() == 2) {
        if (words[0] == "check") return check(words[1]);
        if (words[0] == "certify") return certify(words[1]);
        if (words[0] == "pictures") return pictures(words[1]);
        if (words[0] == "compare") return what_compare_says(words[1]);
        if (words[0] == "memory") return memory(words[1]);
        if (words[0] == "races") return races(words[1]);
        if (words[0] == "trail") {
            std::fputs(in_words(read_trail(read_file(words[1]))).c_str(), stdout);
            return app::done;
        }
    }
    throw app::UsageError(
        "usage: mistake_tool check NN.k, or certify, pictures, compare, memory or races NN_topic, "
        "or program NAMES TARGET FILE, or trail FILE");
}

}  // namespace

int main(int argc, char** argv) {
    return app::run_or_explain("mistake_tool", [&] { return run({argv + 1, argv + argc}); });
}
