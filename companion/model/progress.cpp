#include <companion/model/progress.hpp>

namespace companion {

Progress progress_of(const Course& course, const State& state, const Exercise& exercise) {
    if (!is_begun(course, exercise)) return Progress::to_write;
    const auto found = state.find(exercise.id);
    const bool known = found != state.end() && found->second.hash == hash_of(course, exercise);
    if (known && found->second.passed) return Progress::done;
    if (todos_left(course, exercise) > 0) return Progress::begun;
    return known ? Progress::failing : Progress::unchecked;
}

const char* text(Progress progress) {
    switch (progress) {
        case Progress::to_write:
            return "to be written";
        case Progress::begun:
            return "begun";
        case Progress::unchecked:
            return "not checked since it changed";
        case Progress::failing:
            return "failing";
        case Progress::done:
            return "done";
    }
    return "";
}

char symbol(Progress progress) {
    switch (progress) {
        case Progress::to_write:
            return '.';
        case Progress::begun:
            return '-';
        case Progress::unchecked:
            return '?';
        case Progress::failing:
            return 'x';
        case Progress::done:
            return '+';
    }
    return ' ';
}

const Exercise* first_not_done(const Course& course, const State& state,
                               const std::vector<Exercise>& exercises) {
    for (const Exercise& exercise : exercises)
        if (progress_of(course, state, exercise) != Progress::done) return &exercise;
    return nullptr;
}

}  // namespace companion
