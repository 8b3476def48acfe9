#include <algorithm>
#include <app/errors.hpp>
#include <cmath>
#include <companion/compare/comparison.hpp>
#include <companion/compare/difference_text.hpp>
#include <companion/own/judge.hpp>
#include <companion/own/scenes.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <cstdlib>
#include <sstream>

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
                long_enough(own, request.seed, {"--list", "--threads", "1"}, 5);
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

// Root mean square difference, in linear light, of what both draw on average with the same seeds.
double difference(const OwnProgram& a, const OwnProgram& b, const std::string& scene) {
    std::vector<Picture> of_a, of_b;
    for (int seed = 1; seed <= 8; ++seed) {
        const Options options{"--seed", std::to_string(seed)};
        of_a.push_back(picture_of(a, scene, options));
        of_b.push_back(picture_of(b, scene, options));
    }
    const rt::Image mean_a = mean_of(of_a), mean_b = mean_of(of_b);
    double sum = 0;
    for (std::size_t i = 0; i < mean_a.pixels().size(); ++i) {
        const rt::Color d = mean_a.pixels()[i] - mean_b.pixels()[i];
        sum += d.r * d.r + d.g * d.g + d.b * d.b;
    }
    return std::sqrt(sum / (3 * static_cast<double>(mean_a.pixels().size())));
}

// The time with the option against the time without it, from runs in turns.
double time_ratio(const OwnProgram& with, const OwnProgram& without, const std::string& scene) {
    std::vector<double> ratios;
    for (int turn = 0; turn < 5; ++turn)
        ratios.push_back(fastest(with, scene, {"--threads", "1"}, 1) /
                         fastest(without, scene, {"--threads", "1"}, 1));
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

void judge_accuracy(const JudgeRequest& request, const OwnProgram& own, const Report& report) {
    const fs::path page = request.folder / "accuracy.md";
    const auto choices =
        fs::exists(page) ? accuracy_choices(read_file(page)) : std::vector<AccuracyChoice>{};
    if (choices.size() < 2)
        report({false, "accuracy.md", std::to_string(choices.size()) + " choices with an option",
                "two choices", "Write behind `option:` what build.sh passes to the compiler."});
    const std::string scene = own_rungs(request.seed)[5].scenes[1].text;
    for (const AccuracyChoice& choice : choices)
        report(guarded(
            {false, "accuracy.md: " + choice.option, "",
             "its time within 25 % of what is measured, its error within a factor of 1.5",
             "Write these figures behind `time:` and `error:`."},
            [&](JudgedLine& line) {
                const OwnProgram with{request.folder, {choice.option}};
                const std::string large = long_enough(own, request.seed, {"--threads", "1"}, 1);
                const double time = time_ratio(with, own, large);
                const double error = difference(with, own, scene);
                line.actual = "measured: time " + number(time) + ", error " + number(error, "%.1e");
                if (!choice.time || !choice.error) return;
                line.actual += "; written: time " + number(*choice.time) + ", error " +
                               number(*choice.error, "%.1e");
                const bool error_fits =
                    error == 0 ? *choice.error == 0
                               : *choice.error <= 1.5 * error && error <= 1.5 * *choice.error;
                line.passed = std::abs(*choice.time - time) <= 0.25 * time && error_fits;
            }));
}

}  // namespace

std::vector<AccuracyChoice> accuracy_choices(const std::string& page) {
    std::vector<AccuracyChoice> choices;
    std::istringstream lines{page};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words{line};
        std::string name, value;
        if (!(words >> name >> value)) continue;
        if (name == "option:") choices.push_back({value, {}, {}});
        if (choices.empty() || (name != "time:" && name != "error:")) continue;
        std::optional<double>& figure =
            name == "time:" ? choices.back().time : choices.back().error;
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        if (end != value.c_str()) figure = number;
    }
    return choices;
}

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
    judge_accuracy(request, own, say);
    return all;
}

}  // namespace companion
