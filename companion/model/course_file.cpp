#include <app/value.hpp>
#include <companion/model/course_file.hpp>
#include <companion/system/files.hpp>
#include <mutex>

namespace companion {
namespace {

using app::Value;

int minutes(const Value& value, std::uint64_t least = 1) {
    return static_cast<int>(value.whole(least, 1000));
}

// A text that is not empty.
std::string text(const Value& value) {
    if (value.is_text() && value.text().empty()) value.refuse("a text in quotes");
    return value.text();
}

Exercise read_exercise(const Value& value, const Chapter& chapter) {
    Exercise exercise;
    exercise.id = text(value.at("id"));
    if (exercise.id.rfind(chapter.number() + '.', 0) != 0)
        value.at("id").fail("must begin with " + chapter.number() + '.');
    exercise.title = text(value.at("title"));
    exercise.minutes = minutes(value.at("minutes"), 0);
    if (const auto more = value.find("star_minutes")) exercise.star_minutes = minutes(*more, 0);
    if (const auto several = value.find("several_answers"))
        exercise.several_answers = several->yes();
    for (const Value& file : value.at("files").list("files", 1))
        exercise.files.push_back("exercises/" + chapter.name + '/' + text(file));
    return exercise;
}

Graft read_graft(const Value& value) {
    Graft graft{.title = text(value.at("title")), .minutes = minutes(value.at("minutes"))};
    for (const Value& header : value.at("headers").list("headers", 1))
        graft.headers.push_back(text(header));
    const std::string reads = value.at("reads").word({"nothing", "eye", "scene"});
    graft.reads = reads == "nothing" ? Graft::Reads::nothing
                  : reads == "eye"   ? Graft::Reads::eye
                                     : Graft::Reads::scene;
    if (const auto still = value.find("still")) graft.still = still->yes();
    if (const auto steps = value.find("steps"))
        for (const Value& step : steps->list("steps", 1))
            graft.steps.push_back(static_cast<int>(step.whole(1, 9)));
    return graft;
}

// The steps of the route, chapter by chapter: the core's exercises and the grafts.
std::vector<std::string> steps_of(const CourseFile& file) {
    std::vector<std::string> steps;
    for (const Chapter& chapter : file.chapters) {
        for (const Exercise& exercise : file.exercises)
            if (chapter.core && !exercise.is_star() && exercise.chapter.name == chapter.name)
                steps.push_back(exercise.id);
        if (chapter.graft) steps.push_back("graft " + chapter.number());
    }
    return steps;
}

// The route. It must contain each of these steps once.
std::vector<std::string> read_route(const Value& value, std::vector<std::string> steps) {
    std::vector<std::string> route;
    for (const Value& step : value.list("steps", 1)) {
        route.push_back(text(step));
        if (std::erase(steps, route.back()) == 0)
            step.fail(
                "must be an exercise of the core or a graft, such as \"graft 03\", each of "
                "them once");
    }
    if (!steps.empty()) value.fail("lacks " + steps.front());
    return route;
}

CourseFile parse_course(const std::string& json) {
    const Value whole = Value::parse(json, "course.json");
    CourseFile file;
    for (const Value& value : whole.at("chapters").list("chapters", 1)) {
        Chapter chapter{.name = text(value.at("name")),
                        .title = text(value.at("title")),
                        .core = value.at("core").yes(),
                        .reading = minutes(value.at("reading")),
                        .text = text(value.at("text")),
                        .caption = text(value.at("caption"))};
        if (const auto scene = value.find("scene")) {
            chapter.scene = text(*scene);
            chapter.minutes = minutes(value.at("minutes"));
            if (const auto more = value.find("star_minutes"))
                chapter.star_minutes = minutes(*more, 0);
            file.chapters.push_back(chapter);
            continue;
        }
        chapter.hints = text(value.at("hints"));
        if (const auto needs = value.find("needs")) chapter.needs = text(*needs);
        chapter.uses_real = value.at("uses_real").yes();
        if (const auto seconds = value.find("study_seconds"))
            chapter.study_seconds = minutes(*seconds);
        std::vector<Exercise> exercises;
        for (const Value& one : value.at("exercises").list("exercises", 1))
            exercises.push_back(read_exercise(one, chapter));
        chapter.minutes = chapter.reading;
        for (const Exercise& exercise : exercises) {
            chapter.minutes += exercise.minutes;
            chapter.star_minutes += exercise.star_minutes;
        }
        if (const auto graft = value.find("graft")) {
            chapter.graft = read_graft(*graft);
            chapter.minutes += chapter.graft->minutes;
        }
        file.chapters.push_back(chapter);
        for (Exercise& exercise : exercises) {
            exercise.chapter = chapter;
            file.exercises.push_back(std::move(exercise));
        }
    }
    file.route = steps_of(file);
    if (const auto route = whole.find("route")) file.route = read_route(*route, file.route);
    return file;
}

}  // namespace

CourseFile read_course_file(const Course& course) {
    // The last file read is remembered, because a command asks for it many times. It is not
    // thread_local: MinGW frees a thread's objects before it destroys them.
    static std::mutex reading;
    static std::string known;
    static CourseFile file;
    const std::string json = read_file(course.root / "course.json");
    const std::lock_guard lock{reading};
    if (json != known) {
        file = parse_course(json);
        known = json;
    }
    return file;
}

}  // namespace companion
