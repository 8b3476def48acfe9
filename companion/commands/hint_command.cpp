#include <app/errors.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/hints.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>

namespace companion {
namespace {

std::string solution_of(const Exercise& exercise) {
    std::string files;
    for (const fs::path& file : exercise.files)
        files += (files.empty() ? "" : ", ") +
                 (fs::path{"solutions"} / file.lexically_relative("exercises")).generic_string();
    return files;
}

void print_hint(const std::string& title, int number, std::size_t most, const std::string& words) {
    std::printf("%s\n%s\n",
                bold(title + ", hint " + std::to_string(number + 1) + " of " + std::to_string(most))
                    .c_str(),
                words.c_str());
}

int hint_for_graft(const Course& course) {
    const Chapter chapter = next_graft(course).chapter;
    const std::string id = "graft " + chapter.number();
    const std::vector<std::string> all = hints_of_graft(course, chapter);
    const int number = due_hint(course, id, all.size());
    if (number < static_cast<int>(all.size()))
        print_hint(id + ", " + chapter.graft->title, number, all.size(),
                   plain_hint(all[static_cast<std::size_t>(number)]));
    else
        print(wrapped("There are no more hints for " + id + ": all of them are in " +
                          chapter.hints.generic_string() + ". Read " +
                          chapter.text.generic_string() +
                          ", section Graft, again. Our answer is in " +
                          course.relative(tracer_answer(course, chapter)) + '.',
                      ""));
    return app::done;
}

}  // namespace

int hint(const Course& course, const Given& given) {
    if (given.named == "tracer") return hint_for_graft(course);
    const Exercise exercise = find_exercise(course, *given.named);
    const std::vector<std::string> all = hints_in_view(course, exercise);
    if (all.empty())
        throw app::Failure("there are no hints for " + exercise.id + "; read " +
                           exercise.section());
    const int number = due_hint(course, exercise.id, all.size());
    if (number >= static_cast<int>(all.size())) {
        for (const std::string& hint : all)
            if (const std::string star = parts_of(hint).star; !star.empty())
                std::printf("%s\n", plain_hint(star).c_str());
        print(wrapped("There are no more hints for " + exercise.id + ": all three are in " +
                          exercise.chapter.hints.generic_string() + ". Read " + exercise.section() +
                          " again. The solution is in " + solution_of(exercise) + '.',
                      ""));
        return app::done;
    }
    print_hint(exercise.id + ' ' + exercise.title, number, all.size(),
               plain_hint(all[static_cast<std::size_t>(number)]));
    return app::done;
}

}  // namespace companion
