#include <companion/model/progress.hpp>

namespace companion {

Standing standing(const Course& course, const State& state, const Exercise& exercise) {
    if (!is_begun(course, exercise)) return Standing::to_write;
    const auto found = state.find(exercise.id);
    const bool known = found != state.end() && found->second.hash == hash_of(course, exercise);
    if (known && found->second.passed) return Standing::done;
    if (todos_left(course, exercise) > 0) return Standing::begun;
    return known ? Standing::failing : Standing::unchecked;
}

const char* text(Standing standing) {
    switch (standing) {
        case Standing::to_write:
            return "to be written";
        case Standing::begun:
            return "begun";
        case Standing::unchecked:
            return "not checked since it changed";
        case Standing::failing:
            return "failing";
        case Standing::done:
            return "done";
    }
    return "";
}

char symbol(Standing standing) {
    switch (standing) {
        case Standing::to_write:
            return '.';
        case Standing::begun:
            return '-';
        case Standing::unchecked:
            return '?';
        case Standing::failing:
            return 'x';
        case Standing::done:
            return '+';
    }
    return ' ';
}

const Exercise* first_not_done(const Course& course, const State& state,
                               const std::vector<Exercise>& exercises) {
    for (const Exercise& exercise : exercises)
        if (standing(course, state, exercise) != Standing::done) return &exercise;
    return nullptr;
}

}  // namespace companion
