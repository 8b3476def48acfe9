#include <companion/model/progress.hpp>

namespace companion {

Progress progress_of(const Course& course, const State& state, const Exercise& exercise) {
    if (!trouble_with_files(course, exercise).empty()) return Progress::no_file;
    if (!is_begun(course, exercise)) return Progress::to_write;
    const auto found = state.exercises.find(exercise.id);
    const bool known =
        found != state.exercises.end() && found->second.hash == hash_of(course, exercise);
    if (known && found->second.passed)
        return found->second.open_stars > 0 ? Progress::core : Progress::done;
    if (todos_left(course, exercise) > 0) return Progress::begun;
    return known ? Progress::failing : Progress::unchecked;
}

bool passes(Progress progress) {
    return progress == Progress::core || progress == Progress::done;
}

const char* text(Progress progress) {
    switch (progress) {
        case Progress::no_file:
            return "a file is missing";
        case Progress::to_write:
            return "to be written";
        case Progress::begun:
            return "begun";
        case Progress::unchecked:
            return "not checked since it changed";
        case Progress::failing:
            return "failing";
        case Progress::core:
            return "core passes";
        case Progress::done:
            return "done";
    }
    return "";
}

char symbol(Progress progress) {
    switch (progress) {
        case Progress::no_file:
            return '!';
        case Progress::to_write:
            return '.';
        case Progress::begun:
            return '-';
        case Progress::unchecked:
            return '?';
        case Progress::failing:
            return 'x';
        case Progress::core:
            return '*';
        case Progress::done:
            return '+';
    }
    return ' ';
}

const Exercise* first_open(const Course& course, const State& state,
                           const std::vector<Exercise>& exercises) {
    for (const Exercise& exercise : exercises)
        if (!exercise.is_star() && !passes(progress_of(course, state, exercise))) return &exercise;
    return nullptr;
}

int open_stars_of(const Course& course, const Chapter& chapter) {
    const State state = read_state(course);
    int open = 0;
    for (const Exercise& exercise : exercises(course, chapter))
        if (progress_of(course, state, exercise) == Progress::core)
            open += state.exercises.at(exercise.id).open_stars;
        else if (exercise.is_star())
            open += !passes(progress_of(course, state, exercise));
    return open;
}

}  // namespace companion
