#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <cstdlib>
#include <map>
#include <sstream>

namespace companion {
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

// A hash over files and what is in them.
template <class Read>
std::string hash_over(const std::vector<fs::path>& files, const Read& read) {
    std::string bytes;
    for (const fs::path& file : files) bytes += file.string() + '\n' + read(file) + '\0';
    return hash_of(bytes);
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
    std::map<fs::path, int> users;
    for (const Exercise& exercise : found)
        for (const fs::path& file : exercise.files) ++users[file];
    const auto read = [&](const fs::path& file) {
        return stubs.at(file.lexically_relative(fs::path{"exercises"} / chapter.name));
    };
    for (Exercise& exercise : found)
        if (std::all_of(exercise.files.begin(), exercise.files.end(),
                        [&](const fs::path& file) { return users[file] == 1; }))
            exercise.shipped_hash = hash_over(exercise.files, read);
    return found;
}

std::vector<Exercise> exercises(const Course& course) {
    std::vector<Exercise> all;
    for (const Chapter& chapter : chapters(course))
        for (Exercise& exercise : exercises(course, chapter)) all.push_back(std::move(exercise));
    return all;
}

Exercise find_exercise(const Course& course, const std::string& id) {
    const auto dot = id.find('.');
    const bool is_chapter = dot == std::string::npos;
    // "1.3" is 01.3
    const std::string wanted = (is_chapter ? id.size() : dot) == 1 ? '0' + id : id;
    std::string known;
    for (const Exercise& exercise : exercises(course)) {
        if (exercise.id == wanted) return exercise;
        if (exercise.chapter.number() == wanted.substr(0, 2))
            known += (known.empty() ? "" : ", ") + exercise.id;
    }
    if (is_chapter && wanted.size() == 2 && !known.empty())
        throw app::UsageError("'" + id + "' is a chapter; its exercises are " + known);
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
    return hash_over(exercise.files, [&](const fs::path& file) {
        return fs::exists(course.root / file) ? read_file(course.root / file) : "";
    });
}

bool is_begun(const Course& course, const Exercise& exercise) {
    if (todos_left(course, exercise) < exercise.shipped_todos) return true;
    const auto& files = exercise.files;
    return !exercise.shipped_hash.empty() && hash_of(course, exercise) != exercise.shipped_hash &&
           std::all_of(files.begin(), files.end(),
                       [&](const fs::path& file) { return fs::exists(course.root / file); });
}

int todos_left(const Course& course, const Exercise& exercise) {
    int count = 0;
    for (const fs::path& file : exercise.files)
        count += fs::exists(course.root / file)
                     ? count_todos(read_file(course.root / file), exercise.id)
                     : 1;
    return count;
}

}  // namespace companion
