#include <app/errors.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/hints.hpp>
#include <companion/model/progress.hpp>
#include <companion/model/state.hpp>
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

// Removes Markdown's code marks, which a terminal does not need.
std::string words_of(std::string hint) {
    std::erase(hint, '`');
    return hint;
}

}  // namespace

int hint(const Course& course, const Given& given) {
    const Exercise exercise = find_exercise(course, *given.named);
    const std::vector<std::string> all = hints(course, exercise);
    if (all.empty())
        throw app::Failure("there are no hints for " + exercise.id + "; read " +
                           exercise.section());
    int number = 0;
    change_state(course, [&](State& state) {
        int& shown = state.exercises[exercise.id].hints;
        number = shown;
        if (shown < static_cast<int>(all.size())) ++shown;
    });
    // A star's hints are not shown until the core passes.
    const bool stars =
        exercise.is_star() || passes(progress_of(course, read_state(course), exercise));
    if (number < 0 || number >= static_cast<int>(all.size())) {
        for (const std::string& hint : all)
            if (const std::string star = parts_of(hint).star; stars && !star.empty())
                std::printf("%s\n", words_of(star).c_str());
        print(wrapped("There are no more hints for " + exercise.id + ": all three are in " +
                          exercise.chapter.hints.generic_string() + ". Read " + exercise.section() +
                          " again. The solution is in " + solution_of(exercise) + '.',
                      ""));
        return app::done;
    }
    const std::string& words = all[static_cast<std::size_t>(number)];
    std::printf("%s\n%s\n",
                bold(exercise.id + ' ' + exercise.title + ", hint " + std::to_string(number + 1) +
                     " of " + std::to_string(all.size()))
                    .c_str(),
                words_of(stars ? words : parts_of(words).core).c_str());
    return app::done;
}

}  // namespace companion
