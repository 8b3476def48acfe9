#include <algorithm>
#include <companion/model/course_file.hpp>
#include <companion/model/progress.hpp>
#include <companion/model/route.hpp>

namespace companion {
namespace {

// The elective that has the exercise with this ID; none if it is the core's, or if there is none.
std::optional<Chapter> elective_of(const Course& course, const std::string& id) {
    for (const Exercise& exercise : exercises(course))
        if (exercise.id == id && !exercise.chapter.core) return exercise.chapter;
    return {};
}

}  // namespace

std::vector<Step> route(const Course& course) {
    std::vector<Step> steps;
    const std::vector<Exercise> all = exercises(course);
    for (const std::string& id : read_course_file(course).route) {
        Step step;
        for (const Exercise& exercise : all)
            if (exercise.id == id) step = {exercise, exercise.chapter};
        for (const Chapter& chapter : chapters(course))
            if (id == "graft " + chapter.number()) step = {{}, chapter};
        steps.push_back(step);
    }
    return steps;
}

std::vector<Exercise> exercises_on_route(const Course& course) {
    std::vector<Exercise> all;
    for (Step& step : route(course))
        if (step.exercise) all.push_back(std::move(*step.exercise));
    return all;
}

bool is_open(const Course& course, const State& state, const Step& step) {
    if (step.exercise) return !passes(progress_of(course, state, *step.exercise));
    return !state.grafts.count(step.chapter.number());
}

std::optional<Step> next_in_chapter(const Course& course, const Chapter& chapter) {
    std::vector<Step> steps = route(course);
    std::erase_if(steps, [&](const Step& step) { return step.chapter.name != chapter.name; });
    if (steps.empty())  // an elective
        for (Exercise& exercise : exercises(course, chapter))
            if (!exercise.is_star()) steps.push_back({std::move(exercise), chapter});
    const State state = read_state(course);
    for (Step& step : steps)
        if (is_open(course, state, step)) return std::move(step);
    return {};
}

std::optional<Step> next_on_route(const Course& course, const std::string& after) {
    const State state = read_state(course);
    const std::vector<Step> steps = route(course);
    if (const std::optional<Chapter> elective = elective_of(course, after))
        if (std::optional<Step> next = next_in_chapter(course, *elective)) return next;
    const auto open = [&](const Step& step) { return is_open(course, state, step); };
    const auto here = std::find_if(steps.begin(), steps.end(),
                                   [&](const Step& step) { return step.id() == after; });
    // Exercises that fail and missing files come first.
    auto next = std::find_if(steps.begin(), here, [&](const Step& step) {
        if (!step.exercise) return false;
        const Progress progress = progress_of(course, state, *step.exercise);
        return progress == Progress::failing || progress == Progress::no_file;
    });
    if (next == here) next = std::find_if(here, steps.end(), open);
    if (next == steps.end()) next = std::find_if(steps.begin(), steps.end(), open);
    if (next == steps.end()) return {};
    return *next;
}

}  // namespace companion
