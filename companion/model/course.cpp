#include <algorithm>
#include <app/errors.hpp>
#include <companion/model/course.hpp>
#include <companion/model/course_file.hpp>
#include <companion/system/platform.hpp>
#include <cstdlib>

namespace companion {

fs::path Course::program(const std::string& name) const {
    return build / "bin" / program_name(name);
}

Course this_course() {
    // The tests of the companion use a small course of their own and a shorter timeout.
    if (const char* const folder = std::getenv("COURSE_TEST_FOLDER"))
        return {folder, fs::path{folder} / "build", 4};
    return {COURSE_ROOT, COURSE_BUILD};
}

bool Chapter::is_left_out() const {
    return !needs.empty() && std::string{COURSE_MISSING}.find(needs) != std::string::npos;
}

std::vector<Chapter> every_chapter(const Course& course) {
    return read_course_file(course).chapters;
}

std::vector<Chapter> chapters(const Course& course) {
    std::vector<Chapter> all = every_chapter(course);
    std::erase_if(all, [](const Chapter& chapter) {
        return !chapter.has_exercises() || chapter.is_left_out();
    });
    return all;
}

std::vector<Chapter> core_chapters(const Course& course) {
    std::vector<Chapter> all = chapters(course);
    std::erase_if(all, [](const Chapter& chapter) { return !chapter.core; });
    return all;
}

std::optional<Chapter> chapter_of_task(const Course& course) {
    for (const Chapter& chapter : every_chapter(course))
        if (!chapter.has_exercises()) return chapter;
    return {};
}

Chapter find_chapter(const Course& course, const std::string& name, bool task_too) {
    const std::string number = name.size() == 1 ? '0' + name : name;
    std::string known;
    for (const Chapter& chapter : every_chapter(course)) {
        const std::string topic = chapter.name.substr(chapter.name.find('_') + 1);
        const bool meant = number == chapter.number() || name == chapter.name || name == topic;
        if (meant) check_is_built(chapter);
        if (meant && (chapter.has_exercises() || task_too)) return chapter;
        if (meant)
            throw app::UsageError(
                "chapter " + chapter.number() +
                " has a task instead of exercises: ./course own judge judges it, and " +
                chapter.text.string() + " explains how");
        if (chapter.has_exercises()) known += (known.empty() ? "" : ", ") + chapter.name;
    }
    throw app::UsageError("there is no chapter '" + name + "'; the chapters are " + known);
}

std::vector<fs::path> given_folders(const Course& course, const Chapter& chapter) {
    const fs::path own = fs::path{"chapters"} / chapter.name;
    std::vector<fs::path> kinds;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator{course.root / own, none})
        if (fs::is_directory(entry.path() / "rt")) kinds.push_back(own / entry.path().filename());
    std::sort(kinds.begin(), kinds.end());
    if (kinds.empty() || fs::is_directory(course.root / own / "rt"))
        kinds.insert(kinds.begin(), own);
    return kinds;
}

void check_is_built(const Chapter& chapter) {
    if (chapter.is_left_out())
        throw app::UsageError("chapter " + chapter.number() + " needs " + chapter.needs +
                              ", which is not installed; " + chapter.text.string() +
                              " says how to install it");
}

}  // namespace companion
