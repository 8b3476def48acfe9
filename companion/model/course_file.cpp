#include <algorithm>
#include <app/errors.hpp>
#include <app/json.hpp>
#include <cmath>
#include <companion/model/course_file.hpp>
#include <companion/system/files.hpp>

namespace companion {
namespace {

using Kind = app::Json::Kind;

// A value of course.json and where it stands there.
class Fact {
  public:
    Fact(const app::Json& json, std::string path) : json_{json}, path_{std::move(path)} {}

    [[noreturn]] void fail(const std::string& what) const {
        throw app::UsageError("course.json: " + (path_.empty() ? "the whole" : path_) + ' ' + what);
    }
    Fact operator[](const char* key) const {
        require(json_.kind == Kind::object, "an object, { ... }");
        const std::string path = app::path_of_member(path_, key);
        for (std::size_t i = 0; i < json_.keys.size(); ++i)
            if (json_.keys[i] == key) return {json_.items[i], path};
        throw app::UsageError("course.json: " + path + " is missing");
    }
    std::vector<Fact> list() const {
        require(json_.kind == Kind::list && !json_.items.empty(),
                "a list, [ ... ], of one or more");
        std::vector<Fact> facts;
        for (std::size_t i = 0; i < json_.items.size(); ++i)
            facts.push_back({json_.items[i], app::path_of_item(path_, i)});
        return facts;
    }
    std::string text() const {
        require(json_.kind == Kind::text && !json_.text.empty(), "a text in quotes");
        return json_.text;
    }
    int count(int least = 1) const {
        require(json_.kind == Kind::number && json_.number >= least && json_.number <= 1000 &&
                    json_.number == std::floor(json_.number),
                "a whole number from " + std::to_string(least) + " to 1000");
        return static_cast<int>(json_.number);
    }
    bool has(const char* key) const {
        return std::find(json_.keys.begin(), json_.keys.end(), key) != json_.keys.end();
    }
    bool yes() const {
        require(json_.kind == Kind::boolean, "true or false");
        return json_.number != 0;
    }

  private:
    void require(bool fits, const std::string& wanted) const {
        if (!fits) fail("should be " + wanted);
    }

    const app::Json& json_;
    std::string path_;
};

Exercise read_exercise(const Fact& fact, const Chapter& chapter) {
    Exercise exercise;
    exercise.id = fact["id"].text();
    if (exercise.id.rfind(chapter.number() + '.', 0) != 0)
        fact["id"].fail("should begin with " + chapter.number() + '.');
    exercise.title = fact["title"].text();
    exercise.minutes = fact["minutes"].count();
    if (fact.has("star_minutes")) exercise.star_minutes = fact["star_minutes"].count(0);
    exercise.chapter = chapter;
    for (const Fact& file : fact["files"].list())
        exercise.files.push_back(fs::path{"exercises"} / chapter.name / file.text());
    return exercise;
}

}  // namespace

CourseFile read_course_file(const Course& course) {
    const app::Json json = app::parse_json(read_file(course.root / "course.json"), "course.json");
    CourseFile file;
    for (const Fact& fact : Fact{json, ""}["chapters"].list()) {
        Chapter chapter{.name = fact["name"].text(),
                        .title = fact["title"].text(),
                        .core = fact["core"].yes(),
                        .reading = fact["reading"].count(),
                        .text = fact["text"].text(),
                        .hints = fact["hints"].text(),
                        .caption = fact["caption"].text(),
                        .uses_real = fact["uses_real"].yes()};
        std::vector<Exercise> exercises;
        for (const Fact& exercise : fact["exercises"].list())
            exercises.push_back(read_exercise(exercise, chapter));
        chapter.minutes = chapter.reading;
        for (const Exercise& exercise : exercises) {
            chapter.minutes += exercise.minutes;
            chapter.star_minutes += exercise.star_minutes;
        }
        file.chapters.push_back(chapter);
        for (Exercise& exercise : exercises) {
            exercise.chapter = chapter;
            file.exercises.push_back(std::move(exercise));
        }
    }
    return file;
}

}  // namespace companion
