#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/compared_picture.hpp>
#include <companion/commands/followed.hpp>
#include <companion/compare/program_pictures.hpp>
#include <companion/model/state.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <companion/system/scratch_folder.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>
#include <rt/image_file.hpp>
#include <set>

namespace companion {
namespace {

// Whether one of the options has one of these names, as in --out FILE or --out=FILE.
bool has_any(const std::vector<std::string>& options, const std::set<std::string>& names) {
    return std::any_of(options.begin(), options.end(), [&](const std::string& option) {
        return names.count(option.substr(0, option.find('='))) > 0;
    });
}

// Puts a picture that is given by its bare name, as in "--out mine.png", into out/, where the other
// pictures are.
void place_in_out(const Course& course, std::vector<std::string>& options) {
    const auto placed = [&](const std::string& name) {
        if (name.empty() || fs::path{name}.has_parent_path()) return name;
        app::make_folder(course.out());
        return (course.out() / name).generic_string();
    };
    const std::string with_name = "--out=";
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (options[i].rfind(with_name, 0) == 0)
            options[i] = with_name + placed(options[i].substr(with_name.size()));
        else if (options[i] == "--out" && i + 1 < options.size())
            options[i + 1] = placed(options[i + 1]);
    }
}

// Takes an option away, --spp 4 or --spp=4, and returns its value; empty if it is not there.
std::string taken(std::vector<std::string>& options, const std::string& name) {
    for (auto option = options.begin(); option != options.end(); ++option) {
        const bool is_next = *option == name && option + 1 != options.end();
        if (!is_next && option->rfind(name + '=', 0) != 0) continue;
        const std::string value = is_next ? option[1] : option->substr(name.size() + 1);
        options.erase(option, option + (is_next ? 2 : 1));
        return value;
    }
    return {};
}

// Whether this is a scene file that only the program with all options draws: it has meshes, a
// picture of the sky or rough metal.
bool needs_all_options(const fs::path& file) {
    std::error_code none;
    if (!fs::is_regular_file(file, none) || file.extension() != ".json") return false;
    const std::string text = read_file(file);
    for (const char* const word : {"\"meshes\"", "\"rough\""})
        if (text.find(word) != std::string::npos) return true;
    // A texture has "type": "image", so only the key counts.
    const std::string image = "\"image\"";
    for (auto at = text.find(image); at != std::string::npos; at = text.find(image, at + 1)) {
        const auto next = text.find_first_not_of(" \t\r\n", at + image.size());
        if (next != std::string::npos && text[next] == ':') return true;
    }
    return false;
}

// Whether code from an elective takes part in drawing the picture.
bool draws_by_elective(const std::vector<std::string>& options) {
    return has_any(options,
                   {"--batches", "--sampler", "--filter", "--target-error", "--time-budget"}) ||
           std::any_of(options.begin(), options.end(), needs_all_options);
}

bool asks_for_study(const std::vector<std::string>& options) {
    return has_any(options, {"--study"});
}

// How the names of the programs begin that have what the options ask for. Chapter 08's compile in a
// third of the time of those that have all options.
std::string programs_for(const Chapter& chapter, const std::vector<std::string>& options) {
    const bool all = chapter.number() == "08" && draws_by_elective(options);
    return all && !asks_for_study(options) ? "renderer" : chapter.name;
}

// The picture of another scene gets a file of its own; it does not overwrite the chapter's.
std::string picture_name(const Chapter& chapter, const std::vector<std::string>& options,
                         const std::string& end = "_mine.png") {
    for (const std::string& option : options)
        if (const fs::path scene{option}; fs::is_regular_file(scene))
            return chapter.name + '_' + scene.stem().string() + end;
    return chapter.name + end;
}

// What is wrong with these options, according to one of these programs that was built earlier;
// empty if it accepts them, or if there is no such program yet. So the learner learns of a slip
// before the build.
std::string objection(const Course& course, const std::vector<std::string>& programs,
                      const std::vector<std::string>& options) {
    for (const std::string& built : programs) {
        std::vector<std::string> command{course.program(built).string()};
        if (!fs::exists(command[0])) continue;
        command.insert(command.end(), options.begin(), options.end());
        command.push_back("--describe");
        const Result result = run_process({.command = command, .timeout = 5});
        return result.exit_code == app::bad_input ? printable(result.output) : "";
    }
    return "";
}

// The page of `book --mine` shows the final scene, and says whose code drew it.
void remember_final_scene(const Course& course, const Chapter& chapter, const Yours& yours) {
    const fs::path picture = course.out() / picture_name(chapter, {});
    if (!fs::exists(picture)) return;
    const std::string hash = hash_of(read_file(picture));
    std::vector<std::string> by_learner = yours.passing;
    by_learner.insert(by_learner.end(), yours.failing.begin(), yours.failing.end());
    change_state(course, [&](State& state) { state.drawn = {hash, by_learner}; });
}

// Says in one line what `compare` would say.
void say_whether_it_is_right(const Course& course, const Chapter& chapter, const Yours& yours) try {
    if (const std::string line = compared_in_one_line(course, chapter, yours); !line.empty())
        std::printf("%s\n", line.c_str());
} catch (const std::exception& failed) {  // the picture is drawn all the same
    std::printf("Not compared with the solution's picture: %s\n", failed.what());
}

// Throws app::UsageError if --follow cannot do what is asked.
void check_follow(const Chapter& chapter, const std::vector<std::string>& options) {
    if (!chapter.needs.empty())
        throw app::UsageError(
            "--follow: the rays of chapter " + chapter.number() +
            " run in several processes; those of chapters 02 to 08 can be followed");
    if (has_any(options, {"--out", "--study", "--help", "-h"}))
        throw app::UsageError(
            "--follow draws a file of its own, so it takes no --out and no --study");
    if (draws_by_elective(options))
        throw app::UsageError(
            "--follow takes no scene with meshes, rough metal or a picture of the sky, and no "
            "option of chapters 10 and 11");
}

// Tells what the light of one sample does. The picture below the path has few samples.
int follow_light(const Course& course, const Chapter& chapter, const Followed& followed,
                 const std::vector<std::string>& options) {
    constexpr int few_samples = 9;
    const fs::path drawing = course.program(chapter.name + "_mine");
    const bool has_samples = options_of(drawing).spp > 0;
    if (followed.sample > 0 && !has_samples)
        throw app::UsageError("--follow: chapter " + chapter.number() +
                              " draws without samples: --follow X,Y");
    const ScratchFolder scratch{"course-follow"};
    const fs::path picture = scratch.path() / "picture.ppm";
    const auto command = [&](const fs::path& program, std::vector<std::string> words) {
        words.insert(words.begin(), {program.string(), "--quiet", "--out", picture.string()});
        return words;
    };
    const auto draw = [&] {
        std::vector<std::string> words = options;
        const std::string samples = taken(words, "--spp");
        if (has_samples)
            words.insert(words.end(),
                         {"--spp", std::to_string(samples.empty() ? few_samples
                                                                  : std::min(few_samples,
                                                                             std::stoi(samples)))});
        const Result result = run_process(
            {.command = command(drawing, words), .output = Output::errors_hidden, .timeout = 60});
        if (!result.ok()) throw app::Failure(chapter.name + ": " + how_it_ended(result));
        return parse_ppm(read_file(picture));
    };
    return follow(course,
                  {followed, command(course.program(chapter.name + "_follow"), options), picture,
                   draw, course.out() / picture_name(chapter, options, "-follow.svg")});
}

// Compiles 00.1's one file and draws its picture, for those whose terminal cannot.
int draw_first(const Course& course) {
    app::make_folder(course.out());
    const Drawn drawn =
        draw_by_tracer(course, compile_first(course), {}, course.out() / "00_first.ppm");
    const fs::path shown = course.out() / "00_first.png";
    app::replace_file(shown, rt::encode_png(mean_of({drawn.picture})));
    std::printf("Your picture: %s\n", course.relative(shown).c_str());
    return app::done;
}

}  // namespace

int run(const Course& course, const Given& given) {
    if (given.named == "00.1") return draw_first(course);
    std::vector<std::string> options = given.rest;
    // --mine may also stand among the program's options, because no program has an option of that
    // name.
    const bool all = given.has("--mine") || std::erase(options, "--mine") > 0;
    const std::string wanted =
        given.has("--follow") ? given.options.at("--follow") : taken(options, "--follow");
    const Chapter chapter = find_chapter(course, *given.named);
    std::optional<Followed> followed;
    if (!wanted.empty()) {
        followed = followed_in(wanted);
        check_follow(chapter, options);
    }
    const std::string programs = programs_for(chapter, options);
    const std::string program = programs + (asks_for_study(options) ? "_mine_study" : "_mine");
    if (const std::string why = objection(course, {program, programs + "_solution"}, options);
        !why.empty()) {
        std::fputs(why.c_str(), stderr);
        return app::bad_input;
    }
    const Chapter last = draws_by_elective(options) ? chapters(course).back() : chapter;
    const Yours yours =
        all ? put_all_yours_in_place(course, last) : put_yours_in_place(course, last);
    must_build(course, program);
    if (followed) must_build(course, chapter.name + "_follow");
    std::fprintf(stderr, "%s\n", yours.words().c_str());
    if (!yours.replaced.empty())
        std::fprintf(stderr, "With your code as it is: ./course run %s%s --mine\n",
                     chapter.number().c_str(), followed ? (" --follow " + wanted).c_str() : "");
    if (followed) return follow_light(course, chapter, *followed, options);

    place_in_out(course, options);
    std::vector<std::string> command{course.program(program).string()};
    // Unless they say where to write, or ask for no picture.
    if (!has_any(options, {"--out", "--study", "--help", "-h"})) {
        app::make_folder(course.out());
        const fs::path picture = course.out() / picture_name(chapter, options);
        command.insert(command.end(), {"--out", picture.generic_string()});
    }
    command.insert(command.end(), options.begin(), options.end());
    const Result result =
        run_process({.command = command, .output = Output::printable, .passes_signals = true});
    if (result.passed_on && result.signal) return app::stopped_by + result.signal;
    if (result.signal != 0)
        throw app::Failure(chapter.name + " crashed, " + how_it_ended(result) +
                           "; to find the exercise: ./course check " + chapter.number());
    if (result.ok() && options.empty()) {
        if (chapter.name == core_chapters(course).back().name)
            remember_final_scene(course, chapter, yours);
        say_whether_it_is_right(course, chapter, yours);
    }
    return result.exit_code;
}

int mine(const Course& course, const Given&) {
    return run(course, {.named = core_chapters(course).back().number()});
}

}  // namespace companion
