#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/turn.hpp>
#include <companion/check/check.hpp>
#include <companion/check/prepare.hpp>
#include <companion/check/sanitized.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/commands/shown_verdict.hpp>
#include <companion/model/progress.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>

namespace companion {
namespace {

// The exercises that are meant: "03.2" is one exercise, "3" or "sphere" are those of a chapter, and
// no name means all that are begun.
std::vector<Exercise> chosen(const Course& course, const std::optional<std::string>& name) {
    if (name && name->find('.') != std::string::npos) return {find_exercise(course, *name)};
    if (name) return exercises(course, find_chapter(course, *name));
    const State state = read_state(course);
    std::vector<Exercise> written;
    for (Exercise& exercise : exercises(course))
        if (progress_of(course, state, exercise) != Progress::to_write)
            written.push_back(std::move(exercise));
    return written;
}

bool is_to_write(const Checked& checked) {
    return checked.is<NotBegun>() || checked.is<Begun>() || checked.is<Waiting>();
}
bool is_wrong(const Checked& checked) {
    return !checked.passed() && !is_to_write(checked);
}

// Those chapters of these exercises in which all exercises pass.
std::vector<Chapter> chapters_done(const Course& course, const std::vector<Checked>& all) {
    const State state = read_state(course);
    std::vector<Chapter> done;
    std::string last;
    for (const Checked& checked : all) {
        const Chapter& chapter = checked.exercise.chapter;
        if (chapter.name == last) continue;
        last = chapter.name;
        if (!first_open(course, state, exercises(course, chapter))) done.push_back(chapter);
    }
    return done;
}

void print_chapters_done(const Course& course, const std::vector<Chapter>& done) {
    if (done.size() == 1) print('\n' + chapter_done(done[0], open_stars_of(course, done[0])));
    if (done.size() < 2) return;
    std::string numbers;
    int open = 0;
    for (const Chapter& chapter : done) {
        numbers += ' ' + chapter.number();
        open += open_stars_of(course, chapter);
    }
    print("\n" + green("Done:" + numbers) + (open ? ", " + yellow(stars_open(open)) : "") + '\n');
}

// Runs the checkpoints of one exercise under the sanitizers: the thread sanitizer or the others.
int check_sanitized(const Course& course, const Given& given) {
    std::string name = given.named.value_or(""), sanitizer = given.options.at("--sanitize");
    if (name.empty()) std::swap(name, sanitizer);  // check --sanitize 01.3
    if (name.empty()) throw app::UsageError("check --sanitize: needs an exercise, such as 01.3");
    if (!sanitizer.empty() && sanitizer != "thread" && sanitizer != "address")
        throw app::UsageError("--sanitize: takes nothing, address or thread, not '" + sanitizer +
                              '\'');
    const Exercise exercise = find_exercise(course, name);
    if (const std::string trouble = trouble_with_files(course, exercise); !trouble.empty())
        throw app::Failure(trouble);
    if (const std::string why = instead_of_sanitizers(); !why.empty())
        throw app::Failure("--sanitize: " + why);
    const SanitizedRun run = run_sanitized(course, exercise, sanitizer == "thread");
    print(run.words);
    return run.passed ? app::done : app::could_not;
}

// What comes next after these exercises, of which `open` is the first that is still to be written.
std::string next_among(const Course& course, const std::vector<Exercise>& some,
                       const Exercise& open) {
    if (some.size() == 1) return next_step(course, open);
    const bool is_one_chapter = std::all_of(some.begin(), some.end(), [&](const Exercise& one) {
        return one.chapter.name == open.chapter.name;
    });
    return next_step(
        course, is_one_chapter ? next_in_chapter(course, open.chapter) : next_on_route(course));
}

void print_summary(const std::vector<Checked>& all, const std::string& stars_command) {
    std::string chapter;
    for (const Checked& checked : all) {
        if (checked.exercise.chapter.name != chapter) {
            chapter = checked.exercise.chapter.name;
            print(bold(chapter) + '\n');
        }
        print(summary_line(checked, stars_command));
    }
    if (all.empty()) print("Nothing is written yet.\n");
}

int check_and_tell(const Course& course, const std::vector<Exercise>& some, bool shows_stars) {
    const Turn turn{course};
    const std::string stars_command = some.size() == 1 && !shows_stars ? "--stars" : "";
    const std::vector<Checked> all = check_exercises(
        course, some,
        [&](const std::vector<Checked>& in_double) { print_summary(in_double, stars_command); });
    print(float_lines(all, stars_command));

    // The details are about the exercise where they help most: the first one that is wrong, or else
    // the first one that waits for another or is still to be written.
    auto shown = std::find_if(all.begin(), all.end(), is_wrong);
    const bool wrong = shown != all.end();
    if (!wrong)
        shown =
            std::find_if(all.begin(), all.end(), [](const Checked& one) { return !one.passed(); });
    const auto says_why = [](const Checked& one) {
        const Begun* const begun = std::get_if<Begun>(&one.verdict);
        return one.is<Waiting>() || (begun && !begun->hint.empty());
    };
    if (shown != all.end() && (wrong || says_why(*shown))) {
        print_details(course, *shown);
        return wrong ? app::could_not : app::still_to_write;
    }
    if (shows_stars)
        for (const Checked& checked : all) print_open_stars(course, checked);
    print_chapters_done(course, chapters_done(course, all));
    if (shown != all.end()) {
        print('\n' + next_among(course, some, shown->exercise));
        return app::still_to_write;
    }
    print('\n' +
          next_step(course, next_on_route(course, all.empty() ? "" : all.back().exercise.id)));
    return all.empty() ? app::still_to_write : app::done;
}

}  // namespace

int check(const Course& course, const Given& given) {
    if (given.named == "tracer") return tracer(course, {});
    if (given.has("--sanitize")) return check_sanitized(course, given);
    const std::vector<Exercise> some = chosen(course, given.named);
    const int code = check_and_tell(course, some, given.has("--stars"));
    prepare_in_background(course, next_exercises(course, some.empty() ? "" : some.back().id));
    return code;
}

}  // namespace companion
