#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/build/turn.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/followed.hpp>
#include <companion/commands/judged_lines.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/compare/comparison_sheet.hpp>
#include <companion/model/kept.hpp>
#include <companion/own/graft_reason.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/files.hpp>
#include <companion/system/scratch_folder.hpp>
#include <companion/system/terminal.hpp>
#include <ctime>
#include <regex>
#include <rt/image_file.hpp>

namespace companion {
namespace {

// At first, the tracer is the program of 00.1.
void begin_tracer(const Course& course) {
    const fs::path file = tracer_file(course);
    if (fs::exists(file)) return;
    const fs::path first = course.root / "exercises/00_toolchain/first.cpp";
    const bool written = read_text(first).find("rt::todo") == std::string::npos;
    const fs::path from = written ? first : course.root / "solutions/00_toolchain/first.cpp";
    app::make_folder(file.parent_path());
    fs::copy_file(from, file);
    print("Your tracer begins as a copy of " + course.relative(from) + ": " +
          course.relative(file) + "\n");
}

// Replaces the tracer by our answer to a graft.
int begin_from(const Course& course, const std::string& name) {
    const Chapter chapter = find_chapter(course, name);
    if (!chapter.graft)
        throw app::UsageError("--from: chapter " + chapter.number() + " has no graft");
    const fs::path file = tracer_file(course);
    if (fs::exists(file)) {
        const fs::path kept = new_kept_folder(course, "tracer") / file.filename();
        fs::copy_file(file, kept);
        print("kept   " + course.relative(kept) + '\n');
    }
    app::make_folder(file.parent_path());
    app::replace_file(file, read_file(tracer_answer(course, chapter)));
    change_state(course, [&](State& state) {
        for (const Chapter& earlier : grafts(course))
            if (earlier.name <= chapter.name) state.grafts.emplace(earlier.number(), 0);
    });
    print("begun  " + course.relative(file) + ", from our answer to graft " + chapter.number() +
          ", " + chapter.graft->title + "\n\n" +
          next_step(course, next_on_route(course, "graft " + chapter.number())));
    return app::done;
}

// What may be typed by somebody who is stuck at this graft.
std::string ways_out(const Course& course, const Chapter& chapter) {
    std::string again;
    for (const Chapter& earlier : grafts(course))
        if (earlier.name < chapter.name)
            again = "  ./course tracer --from " + earlier.number() + "  to do this graft again\n";
    return "Stuck? ./course hint tracer shows the next of three hints. Or begin from our answer to "
           "a "
           "graft; your file is kept elsewhere:\n" +
           again + "  ./course tracer --from " + chapter.number() +
           "  to go on without doing this graft\n";
}

// How to have the next graft judged before all of its exercises pass; empty if there is none.
std::string way_on(const Course& course) {
    const State state = read_state(course);
    for (const Chapter& chapter : grafts(course))
        if (!state.grafts.count(chapter.number()))
            return "If you have done graft " + chapter.number() +
                   " already: ./course tracer --graft " + chapter.number() + '\n';
    return {};
}

bool includes(const Course& course, const std::string& header) {
    const std::vector<std::string> headers = headers_of_tracer(course);
    return std::find(headers.begin(), headers.end(), header) != headers.end();
}

// Draws the learner's scene, or what the program draws without a scene, or says why it cannot.
void draw(const Course& course, const Chapter& chapter, bool beside_ours) {
    const Graft& graft = *chapter.graft;
    app::make_folder(course.out());
    const fs::path file = course.out() / "tracer.ppm";
    std::vector<std::string> words;
    // The learner may be ahead of what passes.
    if (graft.reads == Graft::Reads::scene || includes(course, "tracer_call.hpp"))
        words = {course.relative(tracer_scene(course)), course.relative(file)};
    const Picture picture = [&] {
        const WaitingLine waiting{"drawing your picture; Ctrl-C ends it"};
        return draw_by_tracer(course, tracer_program(course), words, file).picture;
    }();
    const fs::path shown = course.out() / "tracer.png";
    app::replace_file(shown, rt::encode_png(mean_of({picture})));
    print("Your picture: " + course.relative(shown) + '\n');
    if (graft.reads != Graft::Reads::scene || !beside_ours) return;
    // A tracer that does not follow paths yet draws different light than the whole program does.
    const std::string answer = graft.still ? "tracer." + chapter.number() : "09_own_solution";
    must_build(course, answer);
    const fs::path other = course.out() / "tracer_ours.ppm";
    words.back() = course.relative(other);
    const Picture ours = [&] {
        const WaitingLine waiting{"drawing ours"};
        return draw_by_tracer(course, course.program(answer), words, other).picture;
    }();
    if (ours.width != picture.width || ours.height != picture.height) return;
    const fs::path beside = course.out() / "tracer_beside_ours.png";
    app::replace_file(beside, rt::encode_png(side_by_side(mean_of({picture}), mean_of({ours}))));
    print("Beside ours:  " + course.relative(beside) + '\n');
}

// Draws the learner's scene in false colors, in the way that a word of --show asks for.
int draw_false_colors(const Course& course, const std::string& word) {
    if (!includes(course, "false_color_image.hpp"))
        throw app::Failure(
            "your tracer has no --show yet; docs/03-sphere.md, section Graft, says how to give it "
            "one");
    const fs::path file = course.out() / "tracer_show.ppm",
                   shown = course.out() / "tracer_show.png";
    app::make_folder(course.out());
    const Drawn drawn = draw_by_tracer(
        course, tracer_program(course),
        {course.relative(tracer_scene(course)), course.relative(file), "--show", word}, file);
    app::replace_file(shown, rt::encode_png(mean_of({drawn.picture})));
    print("Your picture: " + course.relative(shown) + '\n' + drawn.printed);
    return app::done;
}

// Tells what the light of a sample does in the learner's scene. Below the path is a picture with
// few samples.
int follow_in_tracer(const Course& course, const Chapter& chapter, const Followed& followed) {
    if (!includes(course, "tracer_call.hpp"))
        throw app::Failure("--follow needs a tracer that reads a scene: from graft 03 on");
    compile_tracer(course, chapter, true);
    const ScratchFolder scratch{"course-follow"};
    const fs::path picture = scratch.path() / "picture.ppm", scene = scratch.path() / "scene.txt";
    app::replace_file(
        scene, std::regex_replace(read_text(tracer_scene(course)),
                                  std::regex{"(^|\\n)(\\s*picture\\s+\\d+\\s+\\d+\\s+)\\d\\d+"},
                                  "$1$029"));
    return follow(
        course,
        {followed,
         {tracer_program(course, true).string(), tracer_scene(course).string(), picture.string()},
         picture,
         [&] {
             return draw_by_tracer(course, tracer_program(course),
                                   {scene.string(), picture.string()}, picture, 60)
                 .picture;
         },
         course.out() / "tracer-follow.svg"});
}

// The graft that is named, or else the next one.
NextGraft chosen(const Course& course, const Given& given) {
    if (!given.has("--graft")) return next_graft(course);
    const Chapter chapter = find_chapter(course, given.options.at("--graft"));
    if (!chapter.graft)
        throw app::UsageError("--graft: chapter " + chapter.number() + " has no graft");
    return {chapter, true, chapter};
}

}  // namespace

int tracer(const Course& course, const Given& given) {
    const Turn turn{course};  // nothing else may disturb what is measured
    if (given.has("--from")) return begin_from(course, given.options.at("--from"));
    std::optional<Followed> followed;
    if (given.has("--follow")) followed = followed_in(given.options.at("--follow"));
    begin_tracer(course);
    // Which graft is next depends on what passes now, so changed answers are checked first.
    check_what_changed(course, grafts(course).back());
    const NextGraft choice = chosen(course, given);
    const Chapter& chapter = choice.chapter;
    print(bold(given.has("--show") ? "Your scene, in false colors"
               : followed          ? "Your scene, and the light of a sample"
               : choice.is_ready   ? "Graft " + chapter.number() + ": " + chapter.graft->title
                                   : "Your tracer, on the way to graft " + chapter.number()) +
          '\n');
    print(put_yours_in_place(course, chapter).words() + '\n');
    std::string line;
    for (const std::string& word : tracer_command(course, chapter))
        line += (line.empty() ? "" : " ") + word;
    print(dim(line) + '\n');
    compile_tracer(course, chapter);
    if (followed) return follow_in_tracer(course, chapter, *followed);
    if (given.has("--show")) return draw_false_colors(course, given.options.at("--show"));

    bool has_picture = true;
    try {
        draw(course, choice.drawn, choice.is_ready);
    } catch (const app::Failure& failure) {
        print(yellow(std::string{"No picture: "} + failure.what()) + '\n');
        has_picture = false;
    }
    print("\n");
    if (!choice.is_ready) {
        print(next_step(course, next_on_route(course, "graft " + choice.drawn.number())));
        print(way_on(course));
        return has_picture ? app::done : app::could_not;
    }
    const std::uint64_t seed = scenes_seed(given);
    must_build(course, "tracer." + chapter.number());
    JudgedLines lines{course, course.relative(tracer_program(course))};
    // Beside a Vec of its own, the tracer would not use the headers that it includes.
    if (chapter.graft->reads == Graft::Reads::nothing &&
        std::regex_search(read_text(tracer_file(course)),
                          std::regex{"(^|\\n)struct Vec\\b[^;]*\\{"}))
        lines({false, "Vec3 in place of Vec", "tracer.cpp still has a struct Vec",
               "no Vec, and none of its operators and dot: the headers have them for Vec3", ""});
    const GraftRequest request{chapter,
                               tracer_program(course),
                               course.program("tracer." + chapter.number()),
                               headers_of_tracer(course),
                               seed,
                               lines.begins};
    GraftReason reason{course, request, read_file(tracer_file(course))};
    judge_graft(course, request, [&](JudgedLine judged) {
        judged.suggestion = reason(judged);
        lines(judged);
    });
    if (lines.passed < lines.lines) {
        print("The same scenes again: ./course tracer --seed " + std::to_string(seed) + '\n' +
              ways_out(course, chapter));
        return app::could_not;
    }
    bool is_new = false;
    change_state(course, [&](State& state) {
        is_new = state.grafts.emplace(chapter.number(), std::time(nullptr)).second;
    });
    print(green("Graft " + chapter.number() + " passes.") + '\n');
    print('\n' + next_step(course, next_on_route(course, "graft " + chapter.number())));
    if (!is_new) print(way_on(course));
    return app::done;
}

}  // namespace companion
