#include <algorithm>
#include <app/errors.hpp>
#include <companion/check/sanitized.hpp>
#include <companion/compare/comparison.hpp>
#include <companion/compare/difference_text.hpp>
#include <companion/own/scenes.hpp>
#include <companion/own/standing.hpp>
#include <companion/own/trial.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>
#include <optional>
#include <rt/counted.hpp>

namespace companion {
namespace {

using Options = std::vector<std::string>;

// The variance of a pixel or a tile may be this many times as large as ours. Independent samples
// have the same variance as ours; samples that are deliberately spread have less.
constexpr double most_pixel_noise = 2, most_tile_noise = 4;

// What is wrong with a picture; empty if it equals ours within the noise.
std::string what_differs(const Comparison& compared) {
    if (compared.sizes_differ) return "a picture of a different size from what the scene asks for";
    const PictureStatistics& found = compared.statistics;
    auto differing = compared.light_differs_in;
    // Pixels without randomness, such as the sky's, may differ by one rounding step.
    if (found.still_differs())
        for (const TileStatistics& tile : found.tiles)
            if (tile.still_differing > 0) differing.push_back(tile);
    const Picture& picture = compared.mine.front();
    std::string words;
    const auto add = [&](const std::string& more) { words += (words.empty() ? "" : "; ") + more; };
    for (const std::string& where :
         describe_by_region(differing, found.tiles, picture.width, picture.height))
        add(where);
    if (differing.empty() && compared.pixels_differ) {
        double most = 0;
        for (const TileStatistics& tile : found.tiles) most = std::max(most, tile.largest_step);
        add("the light of each tile is right, but single pixels differ, by up to " +
            number(most, "%.1f") + " of 255 steps");
    }
    // Less noise is no fault, but it may explain one: a sample that never moves has none.
    if (found.pixel_noise.ratio > most_pixel_noise ||
        (!words.empty() && 2 * found.pixel_noise.ratio < 1))
        add("the variance of a pixel's noise is " + number(found.pixel_noise.ratio, "%.1f") +
            " times ours");
    else if (found.tile_noise.ratio > most_tile_noise)
        add("neighboring pixels share their noise: the variance of a tile's noise is " +
            number(found.tile_noise.ratio, "%.1f") + " times ours");
    return words;
}

// Where to look if the light is right, and only the noise is wrong.
bool only_noise_differs(const Comparison& compared) {
    return !compared.sizes_differ && compared.light_differs_in.empty() && !compared.pixels_differ &&
           !compared.statistics.still_differs();
}
const char* const about_noise =
    "The light is right, so the formulas are. Does each sample of each pixel get random numbers of "
    "its own, and is the pixel the mean of as many samples as the scene asks for?";

// The program's picture must equal the reference's, within what chance explains. The false-alarm
// rate of one comparison is 1 in 1000, so a fault counts only if two comparisons show it.
void look_at_picture(const Trial& trial, const OwnScene& scene, JudgedLine& line) {
    line.looked = {scene.text, scene.mesh, {}, {}};
    const auto with = [&](const OwnProgram& program) {
        return [&](std::uint64_t seed) {
            return program
                .picture(scene.text, {"--seed", std::to_string(seed % 1'000'000'000 + 1)},
                         scene.mesh)
                .picture;
        };
    };
    const auto ours = [&](std::uint64_t seed) {
        if (!trial.request.ours) return with(trial.reference)(seed);
        Picture& known = (*trial.request.ours)[{scene.text, scene.mesh, seed}];
        if (known.pixels() == 0) known = with(trial.reference)(seed);
        return known;
    };
    for (std::uint64_t time : {1, 2}) {
        const Comparison compared = compare({with(trial.own), ours, true}, time);
        line.actual = what_differs(compared);
        line.looked.pictures = compared;
        line.suggestion = compared.sizes_differ          ? ""
                          : only_noise_differs(compared) ? about_noise
                                                         : scene.suggestion;
        if (!line.actual.empty()) continue;
        line.passed = true;
        line.actual = "the same within the noise, in each of " +
                      std::to_string(compared.statistics.tiles.size()) + " tiles";
        return;
    }
}

void judge_pictures(const Trial& trial, const std::string& part,
                    const std::vector<OwnScene>& scenes) {
    for (const OwnScene& scene : scenes)
        trial.line({false, part + ": " + scene.name, "", "our picture within the noise", ""},
                   [&](JudgedLine& line) { look_at_picture(trial, scene, line); });
}

void judge_seed(const Trial& trial, const OwnScene& scene) {
    trial.line(
        {false, "step 3: --seed", "",
         "a different seed gives different noise, and the same seed gives the same bytes",
         "The random numbers must depend on the seed, the pixel and the sample, and nothing else."},
        [&](JudgedLine& line) {
            line.looked = {scene.text, scene.mesh, {"--seed", "2"}, {}};
            const auto bytes = [&](const char* seed) {
                return trial.own.picture(scene.text, {"--seed", seed}).bytes;
            };
            const std::string one = bytes("1");
            const bool again = bytes("1") == one, other = bytes("2") != one;
            line.passed = again && other;
            line.actual = !again   ? "the same seed gives two different pictures"
                          : !other ? "two different seeds give the same bytes"
                                   : "different noise, and the same bytes again";
        });
}

// How the program is called, and what it prints.
void judge_call(const Trial& trial, const OwnScene& scene) {
    trial.line(
        {false, "step 3: the options before the files", "", "the same bytes",
         "Options begin with --; of the other words, the first is the scene and the second the "
         "picture, wherever they stand."},
        [&](JudgedLine& line) {
            line.looked = {scene.text, scene.mesh, {"--seed", "2"}, {}};
            const Options options{"--seed", "2"};
            line.passed =
                trial.own.picture(scene.text, options, {}, {.options_first = true}).bytes ==
                trial.own.picture(scene.text, options).bytes;
            line.actual = line.passed ? "the same bytes" : "different bytes";
        });
    trial.line({false, "step 3: standard error", "", "nothing",
                "Write what is no error to std::cout, or to no stream at all."},
               [&](JudgedLine& line) {
                   line.looked = {scene.text, scene.mesh, {}, {}};
                   const std::string said =
                       trial.own.picture(scene.text, {}, {}, {.output = Output::errors_only})
                           .result.output;
                   line.passed = said.empty();
                   line.actual =
                       said.empty() ? "nothing" : "the program prints: " + printable(said, 200);
               });
}

// What a sanitizer reports about a run, and where; empty if it is silent.
std::string report_of(const Result& result, const fs::path& folder) {
    if (result.ok() && result.output.empty()) return "";
    const SanitizerReport report = read_sanitizer_report(result.output, own_sources(folder));
    return report.what.empty() ? "own: " + how_it_ended(result) : to_text(report);
}

void judge_sanitized(const Trial& trial) {
    if (!instead_of_sanitizers().empty()) return;
    const std::string small = some_of_all(trial.request.seed),
                      large = crowd(trial.request.seed, 24, 14);
    const std::pair<const char*, const char*> sanitizers[]{
        {"address and undefined behavior", "-fsanitize=address,undefined"},
        {"threads", "-fsanitize=thread"}};
    for (const auto& [name, option] : sanitizers)
        trial.line({false, std::string{"sanitizers: "} + name, "", "silent",
                    std::string{"sh build.sh -O1 -g "} + option +
                        " builds a program that reports the fault with its line."},
                   [&, option = option](JudgedLine& line) {
                       // -g1 is enough to name a line, and compiles in less time.
                       OwnProgram own{trial.request.folder, {"-O1", "-g1", option}};
                       own.before = at_fixed_addresses();
                       own.may_start_others = true;
                       const Options threads{"--threads", "4"};
                       for (const Result& result :
                            {own.draw(small, {"--list"}).result, own.draw(small, threads).result,
                             own.draw(large, threads).result})
                           if (line.actual.empty())
                               line.actual = report_of(result, trial.request.folder);
                       line.passed = line.actual.empty();
                       if (line.passed) line.actual = "silent";
                   });
}

// The program must print one line that says what is wrong, on standard error, and must not crash.
// `call` calls it, and captures all that it prints or only what is on standard error.
void look_at_refusal(const std::function<Result(Output)>& call, JudgedLine& line) {
    const Result result = call(Output::captured);
    const auto lines = std::count(result.output.begin(), result.output.end(), '\n');
    line.passed = result.exit_code > 0 && !result.timed_out && result.signal == 0 && lines == 1 &&
                  result.output.size() > 1;
    line.actual = how_it_ended(result) + ", " + rt::counted(lines, "line") +
                  (lines == 1 ? ": " + printable(result.output, 300) : "");
    if (line.actual.back() == '\n') line.actual.pop_back();
    if (line.passed && call(Output::errors_only).output.empty()) {
        line.passed = false;
        line.actual += ", but not on standard error";
    }
}

// The same of a scene.
void look_at_refused_scene(const Trial& trial, const std::string& scene, const std::string& mesh,
                           JudgedLine& line) {
    line.looked = {scene, mesh, {}, {}};
    look_at_refusal(
        [&](Output output) { return trial.own.draw(scene, {}, mesh, {.output = output}).result; },
        line);
}

const char* const refusal =
    "one line on standard error that says what is wrong, and an exit code other than 0";

void judge_refusals(const Trial& trial, const std::string& part,
                    const std::vector<OwnScene>& scenes) {
    for (const OwnScene& scene : scenes)
        trial.line(
            {false, part + ": " + scene.name, "", refusal, scene.suggestion},
            [&](JudgedLine& line) { look_at_refused_scene(trial, scene.text, scene.mesh, line); });
}

// What the program must refuse in each of these lines; the first that it takes is named.
void judge_limits(const Trial& trial) {
    for (const Limits& limits : broken_limits())
        trial.line({false, "broken: " + limits.name, "", refusal, ""}, [&](JudgedLine& line) {
            for (const std::string& text : limits.scenes) {
                look_at_refused_scene(trial, text, {}, line);
                if (line.passed) continue;
                line.actual = '"' + text.substr(0, text.find('\n')) + "\": " + line.actual;
                return;
            }
        });
}

void judge_broken(const Trial& trial) {
    judge_refusals(trial, "broken", broken_scenes());
    judge_limits(trial);
    for (const BrokenCall& call : broken_calls())
        trial.line({false, "broken: " + call.name, "", refusal, ""}, [&](JudgedLine& line) {
            look_at_refusal([&](Output output) { return trial.own.call(call.words, output); },
                            line);
        });
}

// No ray may slip between triangles that share an edge.
void judge_edges(const Trial& trial) {
    trial.line({false, "step 10: no ray between two triangles", "", "only black pixels",
                "Both triangles of an edge must decide from the same numbers on which side of it "
                "the ray is, "
                "as in the star of 12.1. A ray on the edge itself must hit one of them, or both."},
               [&](JudgedLine& line) {
                   long bright = 0, all = 0;
                   for (const std::uint64_t more : {0, 1, 2, 3}) {
                       const OwnScene scene = shared_corner(4 * trial.request.seed + more);
                       if (bright == 0) line.looked = {scene.text, {}, {}, {}};
                       const Picture picture = trial.own.picture(scene.text, {}).picture;
                       for (long i = 0; i < picture.pixels(); ++i, ++all)
                           bright += picture.bytes[3 * i] != 0;
                   }
                   line.passed = bright == 0;
                   line.actual = line.passed ? "only black pixels"
                                             : "in " + std::to_string(bright) + " of " +
                                                   std::to_string(all) +
                                                   " pixels, rays pass between black triangles";
               });
}

void judge_part(const Trial& trial, const std::string& part) {
    for (const TaskStep& step : task_steps(trial.request.seed)) {
        if (part != "step" + std::to_string(step.number)) continue;
        if (step.number == 3) {
            judge_seed(trial, step.scenes.front());
            judge_call(trial, step.scenes.front());
        }
        judge_pictures(trial, "step " + std::to_string(step.number), step.scenes);
        if (step.number == 8) judge_cores(trial);
        if (step.number == 9) judge_tree(trial);
        if (step.number == 10) {
            judge_edges(trial);
            judge_refusals(trial, "step 10", broken_meshes());
            judge_mesh_tree(trial);
        }
    }
    if (part == "hard") judge_pictures(trial, part, hard_scenes(trial.request.seed));
    if (part == "list") judge_list(trial);
    if (part == "sanitizers") judge_sanitized(trial);
    if (part == "broken") judge_broken(trial);
    if (part == "accuracy") judge_accuracy(trial);
}

}  // namespace

std::vector<std::string> judge_parts() {
    return {"step1", "step2", "step3", "step4", "step5",      "step6",  "step7",
            "step8", "step9", "hard",  "list",  "sanitizers", "broken", "accuracy"};
}

std::vector<std::string> optional_parts() {
    return {"step10"};
}

void judge(const JudgeRequest& request, const std::function<void(const JudgedLine&)>& report) {
    std::optional<OwnProgram> own;
    request.begins("build.sh");
    try {
        own.emplace(request.folder);
    } catch (const app::Failure& failure) {
        report({false, "build.sh", failure.what(), "a program named own", ""});
        return;
    }
    own->patience = request.patience;
    judge_program(*own, request, request.part.empty() ? judge_parts() : std::vector{request.part},
                  report);
}

void judge_program(const OwnProgram& own, const JudgeRequest& request,
                   const std::vector<std::string>& parts,
                   const std::function<void(const JudgedLine&)>& report) {
    const OwnProgram reference{OwnProgram::Existing{}, request.reference};
    bool left_out = false;
    const Trial trial{request, own, reference, [&](JudgedLine line, const auto& look) {
                          left_out = own.times_out() > 1;  // the next run would not end, either
                          if (left_out) return;
                          if (!request.only_line.empty() && line.what != request.only_line) return;
                          request.begins(line.what);
                          try {
                              look(line);
                          } catch (const std::exception& failure) {
                              line.passed = false;
                              line.actual = failure.what();
                          }
                          report(line);
                      }};
    for (const std::string& part : parts) judge_part(trial, part);
    if (left_out)
        report({false, "the rest", "not judged: the program timed out twice", "a program that ends",
                ""});
}

}  // namespace companion
