#include <rt/todo.hpp>
#include <string_view>

namespace rt {
namespace {

// The text that explains a chapter's exercises, according to course.json.
constexpr struct {
    std::string_view chapter;
    const char* text;
} texts[]{
#include "course_texts.inc"
};

std::string explained_in(const std::string& exercise) {
    for (const auto& [chapter, text] : texts)
        if (exercise.substr(0, exercise.find('.')) == chapter)
            return std::string{", explained in "} + text;
    return "";
}

// The part of the path that starts at exercises/, wherever the course was cloned to.
std::string within_course(const std::string& file) {
    const auto start = file.rfind("exercises/");
    return start == std::string::npos ? file : file.substr(start);
}

}  // namespace

NotImplemented::NotImplemented(std::string exercise, const std::string& file, int line)
    : std::logic_error("exercise " + exercise + " is still to be written: " + within_course(file) +
                       ':' + std::to_string(line) + explained_in(exercise) + ", section " +
                       exercise),
      exercise_{std::move(exercise)} {}

void detail::throw_not_implemented(const ExerciseId& exercise) {
    throw NotImplemented(exercise.id, exercise.file, exercise.line);
}

}  // namespace rt
