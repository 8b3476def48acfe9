#include <app/errors.hpp>
#include <companion/model/course.hpp>
#include <companion/model/course_file.hpp>
#include <cstdlib>

namespace companion {

Course this_course() {
    // The tests try the companion on a small course of their own.
    if (const char* const folder = std::getenv("COURSE_TEST_FOLDER"))
        return {folder, fs::path{folder} / "build"};
    return {COURSE_ROOT, COURSE_BUILD};
}

std::vector<Chapter> chapters(const Course& course) {
    return read_course_file(course).chapters;
}

Chapter find_chapter(const std::vector<Chapter>& chapters, const std::string& name) {
    const std::string number = name.size() == 1 ? '0' + name : name;
    std::string known;
    for (const Chapter& chapter : chapters) {
        const std::string topic = chapter.name.substr(chapter.name.find('_') + 1);
        if (number == chapter.number() || name == chapter.name || name == topic) return chapter;
        known += (known.empty() ? "" : ", ") + chapter.name;
    }
    throw app::UsageError("there is no chapter '" + name + "'; there are " + known);
}

}  // namespace companion
