#include <filesystem>
#include <rt/todo.hpp>

namespace rt {
namespace {

// exercises/03_sphere/rt/quadratic.hpp -> docs/03-sphere.md
std::string text_of(const std::filesystem::path& stub) {
    std::string topic = stub.parent_path().parent_path().filename().string();
    if (const auto underscore = topic.find('_'); underscore != std::string::npos)
        topic[underscore] = '-';
    return "docs/" + topic + ".md";
}

// The part of the path that starts at exercises/, wherever the course was cloned to.
std::string within_course(const std::string& file) {
    const auto start = file.rfind("exercises/");
    return start == std::string::npos ? file : file.substr(start);
}

}  // namespace

NotImplemented::NotImplemented(std::string exercise, const std::string& file, int line)
    : std::logic_error("exercise " + exercise + " is still to be written: " + within_course(file) +
                       ':' + std::to_string(line) + ", explained in " + text_of(file) +
                       ", section " + exercise),
      exercise_{std::move(exercise)} {}

void detail::throw_not_implemented(const ExerciseId& exercise) {
    throw NotImplemented(exercise.id, exercise.file, exercise.line);
}

}  // namespace rt
