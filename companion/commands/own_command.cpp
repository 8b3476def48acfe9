#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/turn.hpp>
#include <companion/commands/judged_lines.hpp>
#include <companion/own/judge.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>

namespace companion {
namespace {

// The part that --step or --part asks for; empty means everything.
std::string asked_part(const Given& given) {
    const bool is_step = given.has("--step");
    if (!is_step && !given.has("--part")) return "";
    std::vector<std::string> parts = judge_parts();
    for (const std::string& part : optional_parts()) parts.push_back(part);
    const std::string name =
        is_step ? "step" + given.options.at("--step") : given.options.at("--part");
    if (std::count(parts.begin(), parts.end(), name) > 0) return name;
    if (is_step) throw app::UsageError("--step: the steps are 1 to 10");
    std::string known;
    for (const std::string& one : parts) known += (known.empty() ? "" : ", ") + one;
    throw app::UsageError("--part: there is no part '" + name + "'; the parts are " + known);
}

}  // namespace

int own_new(const Course& course, const Given& given) {
    const std::string& folder = *given.named;
    const fs::path to = fs::absolute(folder);
    if (fs::exists(to) && (!fs::is_directory(to) || !fs::is_empty(to)))
        throw app::UsageError(folder + " exists and is not empty; name a new folder");
    must_build(course, "own_start");
    copy_folder(course.build / "own_start", to);
    change_state(course, [&](State& state) {
        if (!own_passes(state.own)) state.own = {.folder = to.generic_string()};
    });
    print("Your folder is " + to.generic_string() + ". Read TASK.md in it, then write main.cpp.\n" +
          "./course own judge " + folder + " --step 1 tests the first step.\n");
    return app::done;
}

int own_judge(const Course& course, const Given& given) {
    const Turn turn{course};  // nothing else may disturb what is measured
    const std::string &folder = *given.named, part = asked_part(given);
    const std::uint64_t seed = scenes_seed(given);
    print("Scenes of seed " + std::to_string(seed) +
          (part.empty() ? "; this takes a few minutes" : "") + ".\n");

    const fs::path path = fs::absolute(folder).lexically_normal();
    JudgedLines lines{course, (fs::path{folder} / program_name("own")).generic_string()};
    const bool core = judge_own(course, path, seed, part, lines);
    print("\n" + std::to_string(lines.passed) + " of " + std::to_string(lines.lines) +
          " lines pass. To repeat the same scenes: --seed " + std::to_string(seed) + "\n");
    if (part.empty() && core)
        print(
            bold("You are the author of a ray tracer.") +
            (lines.passed < lines.lines ? " Steps 1 to 6 are its core; the rest are stars." : "") +
            " ./course certify\n");
    if (part.empty() && !core)
        print(
            "Steps 1 to 6 are the core, the rest are stars. To judge one step:\n"
            "./course own judge " +
            folder + " --step 1\n");
    if (lines.passed < lines.lines) return part.empty() && core ? app::done : app::could_not;
    if (const auto step = given.number("--step"); step > 0)
        print("Next: ./course own judge " + folder +
              (step < 9 && step != 6 ? " --step " + std::to_string(step + 1) : "") + '\n');
    return app::done;
}

}  // namespace companion
