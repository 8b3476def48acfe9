#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/build/side_build.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/dev/new_exercise.hpp>
#include <companion/dev/parts.hpp>
#include <companion/model/hints.hpp>
#include <companion/model/source.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <companion/system/parallel.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <cstdio>
#include <iterator>
#include <regex>
#include <rt/counted.hpp>
#include <sstream>

namespace companion {
namespace {

constexpr std::size_t few_mistakes = 3, all_hints = 3;

using Lines = std::vector<std::string>;

fs::path mistakes_file(const Exercise& exercise) {
    return fs::path{"tests/mistakes"} / exercise.chapter.name / (exercise.id + ".md");
}

fs::path solution_of(const fs::path& stub) {
    return fs::path{"solutions"} / stub.lexically_relative("exercises");
}

// The files tests/NN_topic/NN.k_NAME.cpp, and all files in tests/NN_topic/NN.k.
std::vector<fs::path> checkpoint_files(const Course& course, const Exercise& exercise) {
    std::vector<fs::path> found;
    const fs::path folder = course.root / "tests" / exercise.chapter.name;
    for (const fs::path& file : source_files(folder)) {
        const std::string name = file.lexically_relative(folder).generic_string();
        if (name.rfind(exercise.id + '_', 0) == 0 || name.rfind(exercise.id + '/', 0) == 0)
            found.push_back(file.lexically_relative(course.root));
    }
    return found;
}

}  // namespace

std::vector<std::string> missing_files(const Course& course, const Exercise& exercise) {
    Lines wrong;
    std::vector<fs::path> needed{mistakes_file(exercise)};
    for (const fs::path& stub : exercise.files)
        needed.insert(needed.end(), {stub, solution_of(stub)});
    for (const fs::path& file : needed)
        if (!fs::exists(course.root / file)) wrong.push_back(file.generic_string() + " is missing");
    const auto all = checkpoint_files(course, exercise);
    const std::string folder = "tests/" + exercise.chapter.name;
    if (std::none_of(all.begin(), all.end(),
                     [&](const fs::path& file) { return file.parent_path() == folder; }))
        wrong.push_back(folder + '/' + exercise.id + "_NAME.cpp is missing: its test cases");
    return wrong;
}

namespace {

void find_marks(const Course& course, const Exercise& exercise, Lines& wrong) {
    std::vector<fs::path> files = checkpoint_files(course, exercise);
    for (const fs::path& stub : exercise.files)
        files.insert(files.end(), {stub, solution_of(stub)});
    files.insert(files.end(), {mistakes_file(exercise), exercise.chapter.text,
                               exercise.chapter.hints, "course.json"});
    for (const fs::path& file : files) {
        if (!fs::exists(course.root / file)) continue;
        std::istringstream in{read_text(course.root / file)};
        int number = 1;
        for (std::string line; std::getline(in, line); ++number)
            if (line.find(unwritten) != std::string::npos)
                wrong.push_back(file.generic_string() + ':' + std::to_string(number) +
                                " is still " + unwritten);
    }
}

void compare_stub(const Course& course, const Exercise& exercise, Lines& wrong) {
    for (const fs::path& stub : exercise.files) {
        const fs::path solution = solution_of(stub);
        if (!fs::exists(course.root / stub) || !fs::exists(course.root / solution)) continue;
        const std::string text = read_text(course.root / stub);
        if (count_todos(text, exercise.id) == 0)
            wrong.push_back(stub.generic_string() + " calls no rt::todo(\"" + exercise.id +
                            "\"): the body of a stub begins with this call");
        if (text.find("Exercise " + exercise.id) == std::string::npos)
            wrong.push_back(stub.generic_string() +
                            " does not say what to write: its comment begins with 'Exercise " +
                            exercise.id + '\'');
        if (stub.extension() != ".hpp") continue;
        const Lines written = signatures(read_text(course.root / solution)),
                    given = signatures(text);
        if (given.empty()) wrong.push_back(stub.generic_string() + " defines no function");
        for (const std::string& signature : given)
            if (std::find(written.begin(), written.end(), signature) == written.end())
                wrong.push_back(stub.generic_string() + " has '" + signature + "', which " +
                                solution.generic_string() +
                                " has not: both need the same functions");
    }
}

// A learner who stops reading at "Star:" reads the core's contract.
void look_for_star(const Course& course, const Exercise& exercise, Lines& wrong) {
    std::string all;
    for (const fs::path& stub : exercise.files)
        // Beside a .cpp, there may be a header with the contract.
        for (const fs::path& file : {stub, fs::path{stub}.replace_extension(".hpp")})
            if (fs::exists(course.root / file)) all += read_text(course.root / file);
    if (all.find("// Star: ") == std::string::npos)
        wrong.push_back(exercise.files.front().generic_string() +
                        " has no line that begins with '// Star:': what only the star's test "
                        "cases check comes after it");
}

void look_into_texts(const Course& course, const Exercise& exercise, Lines& wrong) {
    if (const std::size_t count = hints(course, exercise).size(); count != all_hints)
        wrong.push_back(exercise.chapter.hints.generic_string() + " has " +
                        rt::counted(count, "hint") + " below '## " + exercise.id +
                        "': three are needed: the idea, the formula, and the shape of the code");
    const std::string text = read_text(course.root / exercise.chapter.text);
    const std::regex heading{"(^|\n)### " + exercise.id + " ([^\n]*)"};
    std::smatch found;
    if (!std::regex_search(text, found, heading)) {
        wrong.push_back(exercise.chapter.text.generic_string() + " needs a section '### " +
                        exercise.id + " TITLE (about N minutes)'");
        return;
    }
    const std::string title = found[2], after = found.suffix(),
                      minutes = std::to_string(exercise.is_star() ? exercise.star_minutes
                                                                  : exercise.minutes) +
                                " minutes";
    if (std::regex_search(after, heading))
        wrong.push_back(exercise.chapter.text.generic_string() + " has two sections '### " +
                        exercise.id + '\'');
    if (std::regex_search(title, std::regex{"[0-9]+ minutes"}) &&
        title.find(' ' + minutes) == std::string::npos)
        wrong.push_back(exercise.chapter.text.generic_string() + ": the heading '### " +
                        exercise.id + ' ' + title + "' should say " + minutes +
                        ", as course.json does for the core");
}

// Why the known mistakes cannot be made; empty if they can.
std::string trouble_with_mistakes(const Course& course, const Exercise& exercise) try {
    for (const Mistake& mistake : read_mistakes(course.root / mistakes_file(exercise)))
        edited_files(course, exercise.chapter.name, mistake);
    return "";
} catch (const app::Failure& failure) {
    return with_relative_paths(course, failure.what());
}

void count_mistakes(const Course& course, const Exercise& exercise, Lines& wrong) {
    const fs::path file = mistakes_file(exercise);
    if (!fs::exists(course.root / file)) return;
    if (const std::string trouble = trouble_with_mistakes(course, exercise); !trouble.empty())
        wrong.push_back(trouble);
    else if (const auto count = read_mistakes(course.root / file).size(); count < few_mistakes)
        wrong.push_back(file.generic_string() + " needs at least three known mistakes, but has " +
                        std::to_string(count));
}

// One line for each file that clang-format would change, with the first line that it would change.
void ask_clang_format(const Course& course, const Exercise& exercise, Lines& wrong) {
    if (!is_installed("clang-format")) return;
    std::vector<fs::path> files = checkpoint_files(course, exercise);
    for (const fs::path& stub : exercise.files)
        files.insert(files.end(), {stub, solution_of(stub)});
    for (const fs::path& file : files) {
        if (!fs::exists(course.root / file)) continue;
        const Result result =
            run_process({.command = {"clang-format", "--dry-run", "-Werror", file.generic_string()},
                         .folder = course.root});
        if (result.ok()) continue;
        const std::string name = file.generic_string(),
                          said = result.output.substr(0, result.output.find('\n'));
        std::smatch place;
        if (std::regex_search(said, place, std::regex{"^.+?:[0-9]+(?=:[0-9]+: error: )"}))
            wrong.push_back(place.str() + " is not formatted; run: clang-format -i " + name);
        else
            wrong.push_back("clang-format fails on " + name + ": " + said);
    }
}

std::string quoted_cases(const std::vector<TestCase>& tests) {
    std::string names;
    for (const TestCase& test : tests) names += (names.empty() ? "'" : ", '") + test.name + '\'';
    return names;
}

// Adds what is wrong with the solution's run.
void judge_solution(const Exercise& exercise, const Tested& tested, const std::string& precision,
                    Lines& wrong) {
    std::vector<TestCase> failing = tested.tests;
    std::erase_if(failing, [](const TestCase& test) { return test.passed; });
    if (!failing.empty())
        wrong.push_back("the solution fails in " + precision + ": " + quoted_cases(failing));
    else if (!tested.result.ok())
        wrong.push_back("the solution's check ends with " + how_it_ended(tested.result));
    const auto hard = std::count_if(tested.tests.begin(), tested.tests.end(),
                                    [](const TestCase& test) { return test.hard; });
    if (hard == 0)
        wrong.push_back("no test case is tagged [" + exercise.id +
                        "][hard]: an exercise has a star");
    if (hard == static_cast<long>(tested.tests.size()))
        wrong.push_back("no test case is tagged [" + exercise.id +
                        "] without [hard]: an exercise has a core");
}

void judge_stub(const Exercise& exercise, std::vector<TestCase> tests, Lines& wrong) {
    std::erase_if(tests,
                  [&](const TestCase& test) { return missing_exercise(test) == exercise.id; });
    if (!tests.empty())
        wrong.push_back("if you run " + quoted_cases(tests) +
                        ", the stub does not say that it is still to be written: each test case "
                        "must call it");
}

}  // namespace

std::vector<std::string> wrong_parts(const Course& course, const Exercise& exercise) {
    Lines wrong = missing_files(course, exercise);
    find_marks(course, exercise, wrong);
    compare_stub(course, exercise, wrong);
    look_for_star(course, exercise, wrong);
    look_into_texts(course, exercise, wrong);
    count_mistakes(course, exercise, wrong);
    ask_clang_format(course, exercise, wrong);
    return wrong;
}

std::vector<std::string> wrong_when_run(const Course& course, const Exercise& exercise) {
    Lines wrong;
    for (const bool in_float : {false, true}) {
        if (in_float && !exercise.chapter.uses_real) break;
        const std::string precision = in_float ? "float" : "double",
                          id = exercise.id + (in_float ? ".float" : "");
        const BuildResult built = build(course, {"check." + id, "answer." + id});
        if (!built.ok) {
            wrong.push_back("the solution and its test cases do not compile in " + precision +
                            ": " + first_error(course, built.output));
            return wrong;
        }
        judge_solution(exercise,
                       run_cases(course, {.exercise = exercise.id,
                                          .in_float = in_float,
                                          .answer = course.build / "answers/solution" / precision}),
                       precision, wrong);
    }
    const BuildResult stub = build(course, {"yours." + exercise.id});
    if (stub.ok)
        judge_stub(exercise, run_cases(course, {.exercise = exercise.id}).tests, wrong);
    else
        wrong.push_back("the stub does not compile: " +
                        first_error(course, stub.output, exercise.files));
    if (!trouble_with_mistakes(course, exercise).empty()) return wrong;
    const std::vector<MistakenAnswer> answers =
        make_mistakes(course, exercise, course.build / "mistakes");
    Lines found(answers.size());
    in_parallel(answers.size(), [&](std::size_t i) {
        const auto& [mistake, folder, built] = answers[i];
        if (!built.ok)
            found[i] = mistake.name + " does not compile: " + first_error(course, built.output);
        else if (const Tested all = run_cases(course, {.exercise = exercise.id, .answer = folder});
                 !is_caught(course, answers[i], all.tests))
            found[i] = mistake.name + " is not caught by '" + mistake.caught_by + '\'';
        fs::remove_all(folder);
    });
    std::copy_if(found.begin(), found.end(), std::back_inserter(wrong),
                 [](const std::string& line) { return !line.empty(); });
    return wrong;
}

std::vector<std::string> wrong_in_pictures(const Course& course, const Exercise& exercise) {
    const std::string python = cached(course, "COURSE_DEAD_ENDS");
    if (!exercise.chapter.core || python.empty()) return {};
    std::fprintf(stderr, "Compiling the final scene, which takes a minute.\n");
    const BuildResult built = build(course, {"dead_ends"});
    if (!built.ok) {
        const std::string error = first_error(course, built.output);
        return {"dead_ends cannot be built: " +
                (error.empty() ? "cmake --build build --target dead_ends says why" : error)};
    }
    const Result result = run_process(
        {.command = {python, (course.root / "tests/dead_ends/dead_ends.py").string(), "run",
                     course.root.string(),
                     (course.build / "bin" / program_name("dead_ends")).string(), exercise.id},
         .folder = course.build});
    if (result.ok()) return {};
    return {"dead_ends: " + result.output.substr(0, result.output.find_last_not_of('\n') + 1)};
}

std::vector<std::string> not_asked(const Course& course, const Exercise& exercise) {
    Lines lines;
    if (!is_installed("clang-format"))
        lines.push_back("clang-format was not asked: it is not installed");
    if (exercise.chapter.core && cached(course, "COURSE_DEAD_ENDS").empty())
        lines.push_back(
            "dead_ends was not asked whether a picture needs the exercise: it needs clang++, and a "
            "python3 with libclang (on Debian, the packages clang and python3-clang)");
    return lines;
}

}  // namespace companion
