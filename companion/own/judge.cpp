#include <algorithm>
#include <app/errors.hpp>
#include <companion/compare/comparison.hpp>
#include <companion/compare/difference_text.hpp>
#include <companion/own/judge.hpp>
#include <companion/own/scenes.hpp>
#include <cstdio>
#include <map>

namespace companion {
namespace {

using Report = std::function<void(const JudgedLine&)>;
using Options = std::vector<std::string>;

std::string number(double value, const char* format = "%.2f") {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string seconds(double value) {
    return number(value, "%.2f s");
}

// What a program that failed said, in a few words.
std::string end_of(const OwnProgram::Drawn& drawn) {
    const std::string said = drawn.result.output.substr(0, drawn.result.output.find('\n'));
    return how_it_ended(drawn.result) + (said.empty() ? "" : ": " + said);
}

Picture picture_of(const OwnProgram& program, const std::string& scene, const Options& options) {
    const OwnProgram::Drawn drawn = program.draw(scene, options);
    if (!drawn.result.ok()) throw app::Failure(end_of(drawn));
    return drawn.picture;
}

// The program's picture is the reference's, tile by tile, within what chance explains.
JudgedLine same_picture(const std::string& what, const OwnProgram& own, const OwnProgram& reference,
                        const OwnScene& scene, const Options& more = {}) {
    JudgedLine line{false, what + scene.name, "", "the reference's picture within the noise",
                    scene.suggestion};
    const auto with = [&](const OwnProgram& program) {
        return [&](std::uint64_t seed) {
            Options options{"--seed", std::to_string(seed % 1'000'000'000 + 1)};
            options.insert(options.end(), more.begin(), more.end());
            return picture_of(program, scene.text, options);
        };
    };
    try {
        const Comparison compared = compare({with(own), with(reference), true});
        if (compared.sizes_differ) {
            line.actual = "a picture of another size";
            line.suggestion = "The line `picture` says width, then height.";
            return line;
        }
        const Picture& picture = compared.mine.front();
        auto differing = compared.light_differs_in;
        // Pixels without chance, such as the sky's, may differ by a step of rounding.
        for (const TileStatistics& tile : compared.statistics.tiles)
            if (compared.statistics.still_differs() && tile.still_differing > 0)
                differing.push_back(tile);
        line.passed = differing.empty();
        if (line.passed) {
            line.actual = "no tile of " + std::to_string(compared.statistics.tiles.size()) +
                          " differs by more than chance, " + std::to_string(compared.pictures) +
                          " pictures";
            return line;
        }
        for (const std::string& words : describe_by_region(differing, compared.statistics.tiles,
                                                           picture.width, picture.height))
            line.actual += (line.actual.empty() ? "" : "; ") + words;
    } catch (const app::Failure& failure) {
        line.actual = failure.what();
        line.suggestion = "";
    }
    return line;
}

double fastest(const OwnProgram& program, const std::string& scene, const Options& options,
               int times = 3) {
    double best = 1e9;
    for (int i = 0; i < times; ++i) {
        const OwnProgram::Drawn drawn = program.draw(scene, options, 300);
        if (!drawn.result.ok()) throw app::Failure(end_of(drawn));
        best = std::min(best, drawn.result.seconds);
    }
    return best;
}

// A size at which a picture of this scene takes some seconds, so that starting the program does not
// count.
std::string long_enough(const OwnProgram& program, std::uint64_t seed, const Options& options,
                        double wanted) {
    int width = 32;
    for (;; width *= 2) {
        const std::string scene = crowd(seed, width, width * 9 / 16);
        if (width >= 2048 || fastest(program, scene, options, 1) > wanted) return scene;
    }
}

JudgedLine guarded(JudgedLine line, const std::function<void(JudgedLine&)>& look) {
    try {
        look(line);
    } catch (const app::Failure& failure) {
        line.passed = false;
        line.actual = failure.what();
    }
    return line;
}

void judge_cores(const JudgeRequest& request, const OwnProgram& own, const Report& report) {
    const std::string scene = crowd(request.seed, 96, 54);
    report(
        guarded({false, "rung 8: the same bytes for 1, 2, 3 and 8 threads", "", "the same",
                 "Does a thread draw from another's random numbers, or do two write to one place?"},
                [&](JudgedLine& line) {
                    const std::string one = own.draw(scene, {"--threads", "1"}).bytes;
                    line.passed = !one.empty();
                    line.actual = one.empty() ? "no picture" : "the same";
                    for (const char* threads : {"2", "3", "8"})
                        for (int again = 0; again < 2; ++again)
                            if (own.draw(scene, {"--threads", threads}).bytes != one) {
                                line.passed = false;
                                line.actual = std::string{"others with "} + threads + " threads";
                            }
                }));
    const int cores = std::max(2, request.cores);
    const std::string asked = number(0.8 * request.cores);
    report(guarded(
        {false, "rung 8: " + std::to_string(cores) + " threads against 1", "",
         "at least " + asked + " times as fast",
         "Is a tile or row small enough that nobody waits for the last one? Does a lock "
         "stand in the way?"},
        [&](JudgedLine& line) {
            const std::string large = long_enough(own, request.seed, {"--threads", "1"}, 1);
            const double one = fastest(own, large, {"--threads", "1"});
            const double all = fastest(own, large, {"--threads", std::to_string(cores)});
            line.passed = one / all >= 0.8 * request.cores;
            line.actual =
                number(one / all) + " times as fast (" + seconds(one) + ", " + seconds(all) + ")";
        }));
}

void judge_tree(const JudgeRequest& request, const OwnProgram& own, const Report& report) {
    const std::string scene = crowd(request.seed, 64, 36);
    report(
        guarded({false, "rung 9: --list draws the same bytes", "", "the same",
                 "A box that is too small loses spheres; of equally near ones the one that comes "
                 "last in the file counts."},
                [&](JudgedLine& line) {
                    line.passed = own.draw(scene, {}).bytes == own.draw(scene, {"--list"}).bytes;
                    line.actual = line.passed ? "the same" : "others";
                }));
    report(guarded(
        {false, "rung 9: the tree against --list", "", "at least 10 times as fast",
         "Is the near child searched first, and the far one left out when the hit is nearer?"},
        [&](JudgedLine& line) {
            const std::string large =
                long_enough(own, request.seed, {"--list", "--threads", "1"}, 3);
            const double list = fastest(own, large, {"--list", "--threads", "1"}, 1);
            const double tree = fastest(own, large, {"--threads", "1"});
            line.passed = list >= 10 * tree;
            line.actual = number(list / tree, "%.1f") + " times as fast (" + seconds(list) + ", " +
                          seconds(tree) + ")";
        }));
}

void judge_list_speed(const JudgeRequest& request, const OwnProgram& own,
                      const OwnProgram& reference, const Report& report) {
    report(guarded(
        {false, "the list is no slower than it must be", "", "at most 4 times the reference's list",
         "--list tests every sphere once a ray."},
        [&](JudgedLine& line) {
            const std::string scene = crowd(request.seed, 64, 36);
            const Options list{"--list", "--threads", "1"};
            const double ratio = fastest(own, scene, list, 2) / fastest(reference, scene, list, 2);
            line.passed = ratio <= 4;
            line.actual = number(ratio) + " times";
        }));
}

void judge_sanitized(const JudgeRequest& request, const Report& report) {
    const std::string scene = crowd(request.seed, 24, 14);
    const std::pair<const char*, const char*> sanitizers[]{
        {"address and undefined-behavior sanitizers", "-fsanitize=address,undefined"},
        {"thread sanitizer", "-fsanitize=thread"}};
    for (const auto& [name, option] : sanitizers) {
        const Options options{"-O1", "-g", option};
        report(guarded(
            {false, name, "", "silent", "Its report names the line."}, [&](JudgedLine& line) {
                const OwnProgram own{request.folder, options};
                const OwnProgram::Drawn drawn = own.draw(scene, {"--threads", "4"}, 300);
                line.passed = drawn.result.ok() && drawn.result.output.empty();
                line.actual = line.passed ? "silent" : drawn.result.output.substr(0, 400);
            }));
    }
}

void judge_broken(const OwnProgram& own, const Report& report) {
    for (const OwnScene& scene : broken_scenes())
        report(guarded({false, "a scene file with " + scene.name, "",
                        "one line that says what is wrong, and an exit code other than 0", ""},
                       [&](JudgedLine& line) {
                           const OwnProgram::Drawn drawn = own.draw(scene.text, {}, 20);
                           const std::string& said = drawn.result.output;
                           const auto lines = std::count(said.begin(), said.end(), '\n');
                           line.passed = drawn.result.exit_code > 0 && !drawn.result.timed_out &&
                                         drawn.result.signal == 0 && lines == 1 && said.size() > 1;
                           line.actual = how_it_ended(drawn.result) + ", " + std::to_string(lines) +
                                         (lines == 1 ? " line" : " lines");
                       }));
}

}  // namespace

bool judge(const JudgeRequest& request, const Report& report) {
    bool all = true;
    const Report say = [&](const JudgedLine& line) {
        all = all && line.passed;
        report(line);
    };
    const OwnProgram own{request.folder}, reference = OwnProgram::existing(request.reference);
    for (const Rung& rung : own_rungs(request.seed)) {
        if (request.rung != 0 && rung.number != request.rung) continue;
        for (const OwnScene& scene : rung.scenes)
            say(same_picture("rung " + std::to_string(rung.number) + ": ", own, reference, scene));
        if (rung.number == 8) judge_cores(request, own, say);
        if (rung.number == 9) judge_tree(request, own, say);
    }
    if (request.rung != 0) return all;
    for (const OwnScene& scene : hard_scenes(request.seed))
        say(same_picture("hard: ", own, reference, scene));
    judge_list_speed(request, own, reference, say);
    judge_sanitized(request, say);
    judge_broken(own, say);
    return all;
}

}  // namespace companion
