#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/course_file.hpp>
#include <companion/model/exercise.hpp>
#include <companion/model/stubs.hpp>
#include <companion/system/files.hpp>
#include <map>

namespace companion {
namespace {

// A hash over the names and the contents of files.
template <class Read>
std::string hash_over(const std::vector<fs::path>& files, const Read& read) {
    std::string bytes;
    for (const fs::path& file : files) bytes += file.string() + '\n' + read(file) + '\0';
    return hash_of(bytes);
}

// Fills in the members about the stubs, as they were shipped, of a chapter's exercises.
void add_shipped(const Course& course, std::vector<Exercise>& exercises) {
    const auto read = [&](const fs::path& file) { return shipped_stub(course, file); };
    std::map<fs::path, int> users;
    for (const Exercise& exercise : exercises)
        for (const fs::path& file : exercise.files) ++users[file];
    for (Exercise& exercise : exercises) {
        bool is_known = true;
        for (const fs::path& file : exercise.files) {
            const std::string stub = read(file);
            exercise.shipped_todos += count_todos(stub, exercise.id);
            exercise.functions += static_cast<int>(functions_to_write(stub, exercise.id).size());
            is_known = is_known && !stub.empty() && users[file] == 1;
        }
        if (is_known) exercise.shipped_hash = hash_over(exercise.files, read);
        for (const auto& [file, count] : users) exercise.chapter_files.push_back(file);
    }
}

}  // namespace

std::string Exercise::file_list() const {
    std::string list;
    for (const fs::path& file : files) list += (list.empty() ? "" : ", ") + file.string();
    return list;
}

std::vector<Exercise> exercises(const Course& course, const Chapter& chapter) {
    std::vector<Exercise> found;
    for (Exercise& exercise : read_course_file(course).exercises)
        if (exercise.chapter.name == chapter.name) found.push_back(std::move(exercise));
    add_shipped(course, found);
    return found;
}

std::vector<Exercise> exercises(const Course& course) {
    return exercises(course, chapters(course));
}

std::vector<Exercise> exercises(const Course& course, const std::vector<Chapter>& some) {
    std::vector<Exercise> all;
    for (const Chapter& chapter : some)
        for (Exercise& exercise : exercises(course, chapter)) all.push_back(std::move(exercise));
    return all;
}

Exercise find_exercise(const Course& course, const std::string& id) {
    const auto dot = id.find('.');
    const bool is_chapter = dot == std::string::npos;
    // "1.3" is 01.3
    const std::string wanted = (is_chapter ? id.size() : dot) == 1 ? '0' + id : id;
    // Links lead to the same file: /tmp is one on macOS.
    const fs::path file =
        fs::weakly_canonical(course.root / id).lexically_relative(fs::canonical(course.root));
    std::string known;
    for (const Exercise& exercise : exercises(course)) {
        const auto& files = exercise.files;
        if (exercise.id == wanted || std::find(files.begin(), files.end(), file) != files.end())
            return exercise;
        if (exercise.chapter.number() == wanted.substr(0, 2))
            known += (known.empty() ? "" : ", ") + exercise.id;
    }
    for (const Chapter& chapter : every_chapter(course))
        if (chapter.number() == wanted.substr(0, 2)) check_is_built(chapter);
    if (is_chapter && wanted.size() == 2 && !known.empty())
        throw app::UsageError("'" + id + "' is a chapter; its exercises are " + known);
    throw app::UsageError("there is no exercise '" + id + "'; " +
                          (known.empty() ? "write it as in 01.3: chapter, dot, exercise"
                                         : "chapter " + wanted.substr(0, 2) + " has " + known));
}

std::string hash_of(const Course& course, const Exercise& exercise) {
    std::vector<fs::path> files = exercise.files;
    const auto& known = exercise.chapter_files;
    for (const fs::path& path : source_files(course.root / "exercises" / exercise.chapter.name))
        if (const fs::path file = path.lexically_relative(course.root);
            std::find(known.begin(), known.end(), file) == known.end())
            files.push_back(file);
    return hash_over(files,
                     [&](const fs::path& file) { return text_if_there(course.root / file); });
}

std::string trouble_with_files(const Course& course, const Exercise& exercise) {
    for (const fs::path& file : exercise.files) {
        const fs::path path = course.root / file;
        const std::string why = why_no_file(path);
        if (why.empty()) continue;
        const bool in_the_way = fs::exists(fs::symlink_status(path));
        return file.string() + ' ' + why + "; " + (in_the_way ? "move it away, and " : "") +
               "./course reset " + exercise.id + " restores the stub, and git checkout -- " +
               file.string() + " restores what you last committed";
    }
    // The learner's code may include other files of the chapter, and a compiler would wait at a
    // pipe.
    for (const fs::path& file : exercise.chapter_files)
        if (const fs::path path = course.root / file;
            fs::exists(path) && !why_no_file(path).empty())
            return file.string() + ' ' + why_no_file(path) + "; move it away";
    return "";
}

bool is_begun(const Course& course, const Exercise& exercise) {
    const int left = todos_left(course, exercise);
    if (left == 0 || left < exercise.shipped_todos) return true;
    const auto read = [&](const fs::path& file) { return text_if_there(course.root / file); };
    return !exercise.shipped_hash.empty() &&
           hash_over(exercise.files, read) != exercise.shipped_hash;
}

std::vector<std::string> functions_left(const Course& course, const Exercise& exercise) {
    std::vector<std::string> names;
    for (const fs::path& file : exercise.files) {
        const auto more = functions_to_write(text_if_there(course.root / file), exercise.id);
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

int todos_left(const Course& course, const Exercise& exercise) {
    int count = 0;
    for (const fs::path& file : exercise.files)
        count += count_todos(text_if_there(course.root / file), exercise.id);
    return count;
}

}  // namespace companion
