#include <app/errors.hpp>
#include <course/exercise.hpp>
#include <course/files.hpp>
#include <course/stubs.hpp>
#include <cstdlib>
#include <sstream>

namespace course {
namespace {

// "### 01.3 Length and unit vectors (about 45 minutes)"; an empty id where it is another line.
Exercise from_heading(const std::string& line, const Chapter& chapter) {
    Exercise exercise;
    const std::string start = "### " + chapter.number() + '.', about = " (about ";
    const auto minutes = line.rfind(about);
    const auto space = line.find(' ', start.size());
    if (line.rfind(start, 0) != 0 || minutes == std::string::npos || space >= minutes)
        return exercise;
    exercise.id = line.substr(4, space - 4);
    exercise.title = line.substr(space + 1, minutes - space - 1);
    exercise.minutes = std::atoi(line.c_str() + minutes + about.size());
    exercise.chapter = chapter;
    return exercise;
}

}  // namespace

std::vector<Exercise> exercises(const Course& course, const Chapter& chapter) {
    const Stubs stubs = shipped_stubs(course, chapter);
    std::istringstream text{read_file(course.root / "docs" / chapter.document())};
    std::vector<Exercise> found;
    for (std::string line; std::getline(text, line);) {
        Exercise exercise = from_heading(line, chapter);
        if (exercise.id.empty()) continue;
        for (const auto& [file, source] : stubs)
            if (const int todos = count_todos(source, exercise.id)) {
                exercise.files.push_back(fs::path{"exercises"} / chapter.name / file);
                exercise.shipped_todos += todos;
            }
        found.push_back(exercise);
    }
    return found;
}

std::vector<Exercise> exercises(const Course& course) {
    std::vector<Exercise> all;
    for (const Chapter& chapter : chapters(course))
        for (Exercise& exercise : exercises(course, chapter)) all.push_back(std::move(exercise));
    return all;
}

Exercise find_exercise(const Course& course, const std::string& id) {
    const std::string wanted = id.find('.') == 1 ? '0' + id : id;  // "1.3" is 01.3
    std::string known;
    for (const Exercise& exercise : exercises(course)) {
        if (exercise.id == wanted) return exercise;
        if (exercise.chapter.number() == wanted.substr(0, 2))
            known += (known.empty() ? "" : ", ") + exercise.id;
    }
    throw app::UsageError("there is no exercise '" + id + "'; " +
                          (known.empty() ? "name one as 01.3: chapter, dot, exercise"
                                         : "chapter " + wanted.substr(0, 2) + " has " + known));
}

int hours(const Course& course, const Chapter& chapter) {
    const std::string text = read_file(course.root / "docs" / chapter.document());
    const std::string start = "\nTime: about ";
    const auto at = text.find(start);
    return at == std::string::npos ? 0 : std::atoi(text.c_str() + at + start.size());
}

std::string hash_of(const Course& course, const Exercise& exercise) {
    std::string bytes;
    for (const fs::path& file : exercise.files)
        bytes += file.string() + '\n' +
                 (fs::exists(course.root / file) ? read_file(course.root / file) : "") + '\0';
    return hash_of(bytes);
}

int todos_left(const Course& course, const Exercise& exercise) {
    int count = 0;
    for (const fs::path& file : exercise.files)
        count += fs::exists(course.root / file)
                     ? count_todos(read_file(course.root / file), exercise.id)
                     : 1;
    return count;
}

}  // namespace course
