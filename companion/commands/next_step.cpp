#include <companion/check/verdict_text.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/model/progress.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/terminal.hpp>

namespace companion {
namespace {

// The electives that are not finished, one line each.
std::string electives_left(const Course& course) {
    const State state = read_state(course);
    std::string text;
    for (const Chapter& chapter : chapters(course)) {
        if (chapter.core || !first_open(course, state, exercises(course, chapter))) continue;
        text += "Beyond the course, an elective: " + bold(chapter.number() + ' ' + chapter.title) +
                ", about " + std::to_string(chapter.minutes) + " minutes\n  read   " +
                chapter.text.string() + "\n  check  ./course watch " + chapter.number() + '\n';
    }
    return text;
}

// The next step when every exercise passes: the chapter with a task, then the certificate.
std::string step_after_the_exercises(const Course& course) {
    if (!chapter_of_task(course) || own_passes(read_state(course).own))
        return "The last step: ./course certify\n" + electives_left(course);
    return next_of_own(course);
}

}  // namespace

std::string next_of_own(const Course& course) {
    const auto task = chapter_of_task(course);
    const OwnRecord own = read_state(course).own;
    const std::string folder = own.folder.empty() ? "FOLDER" : own.folder;
    return "Next: " + bold(task->number() + ' ' + task->title) + ", about " +
           std::to_string(task->minutes) + " minutes\n  read   " + task->text.string() + '\n' +
           (own.folder.empty() ? "  begin  ./course own new FOLDER\n" : "") +
           "  check  ./course own judge " + folder + '\n';
}

std::string next_step(const Course& course, const std::optional<Step>& next) {
    if (!next)
        return (electives_left(course).empty() ? "Every exercise passes. "
                                               : "Every exercise of the core passes. ") +
               step_after_the_exercises(course);
    if (next->exercise) return next_step(course, *next->exercise);
    const Graft& graft = *next->chapter.graft;
    return "Next: " + bold(next->id() + ", " + graft.title) + ", about " +
           std::to_string(graft.minutes) + " minutes, in your own tracer\n  read   " +
           next->chapter.text.string() + ", section Graft\n  write  exercises/tracer/tracer.cpp\n" +
           "  check  ./course tracer\n";
}

std::string next_step(const Course& course, const Exercise& next) {
    if (const std::string trouble = trouble_with_files(course, next); !trouble.empty())
        return red(trouble) + '\n';
    const std::string stars = std::to_string(next.star_minutes);
    return "Next: " + bold(next.id + ' ' + next.title) + ", about " +
           (next.is_star() ? stars + " minutes, a star"
                           : std::to_string(next.minutes) + " minutes") +
           (!next.is_star() && next.star_minutes > 0 ? " (its stars: " + stars + " more)" : "") +
           "\n  read   " + next.section() + "\n  write  " + next.file_list() +
           "\n  check  ./course check " + next.id + '\n';
}

std::string chapter_done(const Chapter& chapter, int open_stars) {
    const std::string number = chapter.number();
    return (open_stars == 0
                ? green("Chapter " + number + " is done: every checkpoint passes.")
                : green("Chapter " + number + " is done: its core passes.") + ' ' +
                      yellow(stars_open(open_stars) + ": ./course check " + number + " --stars")) +
           "\n  Look at your picture:          ./course run " + number +
           "\n  Compare it with the solution:  ./course compare " + number +
           "\n  Answer its questions:          ./course ask " + number + '\n';
}

}  // namespace companion
