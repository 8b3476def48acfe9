#include <algorithm>
#include <app/errors.hpp>
#include <companion/check/prepare.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/model/progress.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>

namespace companion {
namespace {

struct Work {
    int done = 0, exercises = 0, stars = 0, open_stars = 0;
    double minutes = 0, minutes_left = 0;  // of the core
    double star_minutes = 0;
};

std::string marked(Progress progress) {
    const std::string text = std::string{symbol(progress)} + ' ';
    switch (progress) {
        case Progress::core:
        case Progress::done:
            return green(text);
        case Progress::failing:
        case Progress::no_file:
            return red(text);
        case Progress::to_write:
            return dim(text);
        default:
            return yellow(text);
    }
}

// "2.5 hours"
std::string hours(double minutes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f hours", minutes / 60);
    return text;
}

// "stars: 5 of 7, 1.5 hours". Only exercises whose core passes count here.
std::string stars_of(const Work& work) {
    std::string text = "stars: ";
    if (work.stars > 0)
        text += std::to_string(work.stars - work.open_stars) + " of " + std::to_string(work.stars) +
                " checked, ";
    return text + hours(work.star_minutes);
}

// The chapter's name, padded to the width of its column.
std::string name_of(const Chapter& chapter) {
    return bold(chapter.name +
                std::string(16 - std::min<std::size_t>(16, chapter.name.size()), ' '));
}

// The share of the reading that is done is assumed to be the share of the exercises that pass.
Work work_of(const Course& course, const State& state, const Chapter& chapter,
             const std::vector<Exercise>& all) {
    Work result;
    double of_exercises = 0, left = 0;
    for (const Exercise& exercise : all) {
        const bool done = passes(progress_of(course, state, exercise));
        if (exercise.is_star() && !done) continue;
        result.done += done;
        if (done) {
            result.stars += state.exercises.at(exercise.id).stars;
            result.open_stars += state.exercises.at(exercise.id).open_stars;
        }
        ++result.exercises;
        of_exercises += exercise.minutes;
        if (!done) left += exercise.minutes;
    }
    result.minutes = chapter.minutes;
    result.star_minutes = chapter.star_minutes;
    result.minutes_left = result.minutes * left / of_exercises;
    return result;
}

// A chapter's line, its exercises and its graft.
void print_chapter(const Course& course, const State& state, const Chapter& chapter,
                   const std::vector<Exercise>& all, const Work& part) {
    std::printf("%s %s %d of %d, %s%s; %s\n", name_of(chapter).c_str(),
                bar(part.done, part.exercises, 10).c_str(), part.done, part.exercises,
                chapter.core ? "" : "elective, ", hours(part.minutes).c_str(),
                stars_of(part).c_str());
    for (const Exercise& exercise : all) {
        const Progress now = progress_of(course, state, exercise);
        std::string more;
        if (now == Progress::core)
            more = ", " + stars_open(state.exercises.at(exercise.id).open_stars);
        else if (exercise.is_star() && !passes(now))
            more = ", all of it a star";  // so the chapter's count leaves it out
        std::printf("  %s%s  %-38s %s%s\n", marked(now).c_str(), exercise.id.c_str(),
                    exercise.title.c_str(), text(now), more.c_str());
    }
    if (chapter.graft)
        std::printf(
            "  %s  graft %s\n",
            marked(state.grafts.count(chapter.number()) ? Progress::done : Progress::to_write)
                .c_str(),
            chapter.graft->title.c_str());
}

// Chapter 09, whose steps another command judges.
void print_own(const State& state, const Chapter& chapter) {
    std::printf("%s %s %s, %s\n", name_of(chapter).c_str(),
                bar(state.own.passed, std::max(1, state.own.lines), 10).c_str(),
                standing_of(state.own).c_str(), hours(chapter.minutes).c_str());
}

// One chapter, and what comes next in it.
int list_chapter(const Course& course, const Chapter& chapter) {
    const State state = read_state(course);
    if (!chapter.has_exercises()) {
        print_own(state, chapter);
        print('\n' + next_of_own(course));
        return app::done;
    }
    const std::vector<Exercise> all = exercises(course, chapter);
    print_chapter(course, state, chapter, all, work_of(course, state, chapter, all));
    const std::optional<Step> next = next_in_chapter(course, chapter);
    print('\n' +
          (next ? next_step(course, next) : chapter_done(chapter, open_stars_of(course, chapter))));
    if (next && next->exercise) prepare_in_background(course, {*next->exercise});
    return app::done;
}

}  // namespace

int list(const Course& course, const Given& given) {
    if (given.named) return list_chapter(course, find_chapter(course, *given.named));
    const State state = read_state(course);
    Work total, electives;
    for (const Chapter& chapter : every_chapter(course)) {
        if (!chapter.has_exercises()) {
            print_own(state, chapter);
            total.minutes += chapter.minutes;
            if (!own_passes(state.own)) total.minutes_left += chapter.minutes;
            continue;
        }
        const std::vector<Exercise> all = exercises(course, chapter);
        const Work part = work_of(course, state, chapter, all);
        print_chapter(course, state, chapter, all, part);
        if (!chapter.core) {
            electives.done += part.done;
            electives.exercises += part.exercises;
            continue;
        }
        total.done += part.done;
        total.exercises += part.exercises;
        total.minutes += part.minutes;
        total.star_minutes += part.star_minutes;
        total.stars += part.stars;
        total.open_stars += part.open_stars;
        total.minutes_left += part.minutes_left;
    }
    std::printf("\n%s %d of %d exercises, %s of %s left; %s\n",
                bar(total.done, total.exercises, 30).c_str(), total.done, total.exercises,
                hours(total.minutes_left).c_str(), hours(total.minutes).c_str(),
                stars_of(total).c_str());
    if (electives.done > 0)
        std::printf("Beyond the course: %d of %d exercises in electives\n", electives.done,
                    electives.exercises);
    std::printf("\n%s", next_step(course, next_on_route(course)).c_str());
    if (total.done + electives.done == 0)
        std::printf("%s", dim("You may begin at any chapter, such as with ./course 07: in checks "
                              "and pictures, the "
                              "solutions stand in for what you skip.\n")
                              .c_str());
    prepare_in_background(course, next_exercises(course));
    return app::done;
}

}  // namespace companion
