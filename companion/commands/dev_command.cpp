#include <algorithm>
#include <app/errors.hpp>
#include <companion/commands/commands.hpp>
#include <companion/dev/new_exercise.hpp>
#include <companion/dev/parts.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>

namespace companion {

int dev_new(const Course& course, const Given& given) {
    const std::string id = *given.named;
    if (!given.has("--name"))
        throw app::UsageError("dev new: needs --name, the name of the exercise's function");
    for (const fs::path& file : begin_exercise(course, id, given.options.at("--name")))
        print(file.string() + '\n');
    print("What a person must write is marked " + std::string{unwritten} + ". ./course dev check " +
          id + " says what is missing.\n");
    return app::done;
}

int dev_check(const Course& course, const Given& given) {
    const Exercise exercise = find_exercise(course, *given.named);
    std::vector<std::string> wrong = wrong_parts(course, exercise);
    const bool is_written = std::none_of(wrong.begin(), wrong.end(), [](const std::string& line) {
        return line.find(unwritten) != std::string::npos;
    });
    if (is_written && missing_files(course, exercise).empty()) {  // or else nothing can be built
        std::fprintf(stderr,
                     "Compiling its test cases and mistakes; the first time takes a while.\n");
        for (std::string& line : wrong_when_run(course, exercise)) wrong.push_back(std::move(line));
    }
    if (wrong.empty()) wrong = wrong_in_pictures(course, exercise);
    for (const std::string& line : wrong) print(line + '\n');
    if (!wrong.empty()) return app::could_not;
    print(exercise.id + " has all of its parts, and they are right.\n");
    for (const std::string& line : not_asked(course, exercise)) print(line + '\n');
    return app::done;
}

}  // namespace companion
