#include <companion/model/course_file.hpp>
#include <companion/model/fact.hpp>
#include <companion/system/files.hpp>

namespace companion {
namespace {

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
    for (const Fact& fact : Fact{json, "course.json"}["chapters"].list()) {
        Chapter chapter{.name = fact["name"].text(),
                        .title = fact["title"].text(),
                        .core = fact["core"].yes(),
                        .reading = fact["reading"].count(),
                        .text = fact["text"].text(),
                        .caption = fact["caption"].text()};
        if (fact.has("scene")) {
            chapter.scene = fact["scene"].text();
            chapter.minutes = fact["minutes"].count();
            file.chapters.push_back(chapter);
            continue;
        }
        chapter.hints = fact["hints"].text();
        chapter.uses_real = fact["uses_real"].yes();
        if (fact.has("study_seconds")) chapter.study_seconds = fact["study_seconds"].count();
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
