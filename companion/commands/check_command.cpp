#include <algorithm>
#include <app/errors.hpp>
#include <companion/check/check.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/progress.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>

namespace companion {
namespace {

// The exercises that a person means by "03.2", by "3" or "sphere", or by nothing: those of which
// something is written.
std::vector<Exercise> chosen(const Course& course, const Named& name) {
    if (name && name->find('.') != std::string::npos) return {find_exercise(course, *name)};
    if (name) return exercises(course, find_chapter(chapters(course), *name));
    const State state = read_state(course);
    std::vector<Exercise> written;
    for (Exercise& exercise : exercises(course))
        if (progress_of(course, state, exercise) != Progress::to_write)
            written.push_back(std::move(exercise));
    return written;
}

bool is_wrong(const Checked& checked) {
    return checked.verdict != Verdict::passed && checked.verdict != Verdict::to_write &&
           checked.verdict != Verdict::waiting;
}

// The chapters among these whose exercises are all done.
std::vector<Chapter> chapters_done(const Course& course, const std::vector<Checked>& all) {
    const State state = read_state(course);
    std::vector<Chapter> done;
    std::string last;
    for (const Checked& checked : all) {
        const Chapter& chapter = checked.exercise.chapter;
        if (chapter.name == last) continue;
        last = chapter.name;
        if (!first_not_done(course, state, exercises(course, chapter))) done.push_back(chapter);
    }
    return done;
}

void print_chapters_done(const std::vector<Chapter>& done) {
    if (done.size() == 1) print('\n' + chapter_done(done[0]));
    if (done.size() < 2) return;
    std::string numbers;
    for (const Chapter& chapter : done) numbers += ' ' + chapter.number();
    print("\n" + green("Done, every checkpoint passes:" + numbers) + '\n');
}

}  // namespace

int check(const Course& course, const Named& name) {
    const std::vector<Exercise> some = chosen(course, name);
    const std::vector<Checked> all = check_exercises(course, some);
    std::string chapter;
    for (const Checked& checked : all) {
        if (checked.exercise.chapter.name != chapter) {
            chapter = checked.exercise.chapter.name;
            print(bold(chapter) + '\n');
        }
        print(summary_line(checked));
    }
    if (all.empty()) print("Nothing is written yet.\n");

    // What helps most: the first that is wrong, else the first that waits or is to be written.
    auto shown = std::find_if(all.begin(), all.end(), is_wrong);
    const bool wrong = shown != all.end();
    if (!wrong)
        shown = std::find_if(all.begin(), all.end(),
                             [](const Checked& one) { return one.verdict != Verdict::passed; });
    if (shown != all.end() &&
        (wrong || shown->verdict == Verdict::waiting || !shown->trouble.empty())) {
        print('\n' + details(course, *shown));
        return wrong ? app::could_not : app::still_to_write;
    }
    print_chapters_done(chapters_done(course, all));
    if (shown != all.end()) {
        print('\n' + next_step(course, &shown->exercise));
        return app::still_to_write;
    }
    const std::vector<Exercise> every = exercises(course);
    print('\n' + next_step(course, first_not_done(course, read_state(course), every)));
    return all.empty() ? app::still_to_write : app::done;
}

}  // namespace companion
