#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/check/yours.hpp>
#include <companion/commands/commands.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>
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

// Whether this is a scene file with meshes.
bool has_meshes(const fs::path& file) {
    std::error_code none;
    return fs::is_regular_file(file, none) && file.extension() == ".json" &&
           read_file(file).find("\"meshes\"") != std::string::npos;
}

// Whether code from an elective takes part in drawing the picture.
bool draws_by_elective(const std::vector<std::string>& options) {
    return has_any(options,
                   {"--batches", "--sampler", "--filter", "--target-error", "--time-budget"}) ||
           std::any_of(options.begin(), options.end(), has_meshes);
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
std::string picture_name(const Chapter& chapter, const std::vector<std::string>& options) {
    for (const std::string& option : options)
        if (const fs::path scene{option}; fs::is_regular_file(scene))
            return chapter.name + '_' + scene.stem().string() + "_mine.png";
    return chapter.name + "_mine.png";
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

}  // namespace

int run(const Course& course, const Given& given) {
    std::vector<std::string> options = given.rest;
    // --mine may also stand among the program's options, because no program has an option of that
    // name.
    const bool all = given.has("--mine") || std::erase(options, "--mine") > 0;
    const Chapter chapter = find_chapter(course, *given.named);
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
    std::fprintf(stderr, "%s\n", yours.words().c_str());

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
    if (result.ok() && options.empty() && chapter.name == core_chapters(course).back().name)
        remember_final_scene(course, chapter, yours);
    return result.exit_code;
}

int mine(const Course& course, const Given&) {
    return run(course, {.named = core_chapters(course).back().number()});
}

}  // namespace companion
