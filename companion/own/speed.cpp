#include <algorithm>
#include <app/errors.hpp>
#include <companion/own/scenes.hpp>
#include <companion/own/trial.hpp>
#include <cstdio>
#include <functional>
#include <study/median.hpp>

namespace companion {
namespace {

double time_of(const Timed& timed, const std::string& scene, Clock clock, const std::string& mesh) {
    const Result result = timed.program.draw(scene, timed.options, mesh).result;
    if (!result.ok()) throw app::Failure("own: " + how_it_ended(result));
    return clock == Clock::wall ? result.seconds : result.cpu_seconds;
}

std::string times_as_fast(const Turns& turns) {
    return number(turns.ratio) + " times as fast (" + number(turns.first, "%.2f s") + ", " +
           number(turns.second, "%.2f s") + ")";
}

using SceneOfWidth = std::function<OwnScene(int width)>;

SceneOfWidth crowds(std::uint64_t seed, int spheres) {
    return [=](int width) { return OwnScene{"", crowd(seed, width, width * 9 / 16, spheres), ""}; };
}

// The first scene that takes longer than the wanted seconds, or is 2048 pixels wide, while the
// width grows.
OwnScene wide_enough(const Timed& timed, Clock clock, double wanted, int width,
                     const SceneOfWidth& scene_of) {
    for (;; width = width * 3 / 2) {
        OwnScene scene = scene_of(width);
        if (width >= 2048 || time_of(timed, scene.text, clock, scene.mesh) > wanted) return scene;
    }
}

void look_at_list(const Trial& trial, const OwnScene& scene, JudgedLine& line) {
    line.looked = {scene.text, scene.mesh, {"--list"}, {}};
    line.passed = trial.own.picture(scene.text, {}, scene.mesh).bytes ==
                  trial.own.picture(scene.text, {"--list"}, scene.mesh).bytes;
    line.actual = line.passed ? "the same bytes" : "different bytes";
}

void look_at_tree(const Trial& trial, double wanted, int width, const SceneOfWidth& scene_of,
                  JudgedLine& line) {
    const Timed list{trial.own, {"--list", "--threads", "1"}}, tree{trial.own, {"--threads", "1"}};
    const OwnScene scene = wide_enough(list, Clock::processor, wanted, width, scene_of);
    line.looked = {scene.text, scene.mesh, {}, {}};
    const Turns turns =
        in_turns(list, tree, scene.text, Clock::processor, 3, trial.request.tree_gain, scene.mesh);
    line.passed = turns.ratio >= trial.request.tree_gain;
    line.actual = times_as_fast(turns);
}

}  // namespace

std::string number(double value, const char* format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

Turns in_turns(const Timed& first, const Timed& second, const std::string& scene, Clock clock,
               int turns, std::optional<double> asked, const std::string& mesh) {
    std::vector<double> of_first, of_second, ratios;
    int enough = 0, too_few = 0;  // turns in which the ratio is at least, or below, what is asked
    while (static_cast<int>(ratios.size()) < turns && 2 * std::max(enough, too_few) <= turns) {
        of_first.push_back(time_of(first, scene, clock, mesh));
        of_second.push_back(time_of(second, scene, clock, mesh));
        ratios.push_back(of_first.back() / of_second.back());
        if (asked) ++(ratios.back() >= *asked ? enough : too_few);
    }
    return {study::median(of_first), study::median(of_second), study::median(ratios)};
}

std::string long_enough(const Timed& timed, std::uint64_t seed, Clock clock, double wanted,
                        int spheres) {
    return wide_enough(timed, clock, wanted, 16, crowds(seed, spheres)).text;
}

void judge_cores(const Trial& trial) {
    trial.line(
        {false, "step 8: the same bytes for 1, 2, 3 and 8 threads", "", "the same bytes",
         "Does a thread use another thread's random numbers, or do two threads write to the "
         "same memory?"},
        [&](JudgedLine& line) {
            const std::string scene = crowd(trial.request.seed, 160, 90, trial.request.crowd);
            line.looked = {scene, {}, {"--threads", "1"}, {}};
            const std::string one = trial.own.picture(scene, {"--threads", "1"}).bytes;
            line.passed = true;
            line.actual = "the same bytes";
            for (const char* threads : {"2", "3", "8"})
                for (int again = 0; line.passed && again < 2; ++again)
                    if (trial.own.picture(scene, {"--threads", threads}).bytes != one) {
                        line.passed = false;
                        line.actual = std::string{"different bytes with "} + threads + " threads";
                        line.looked.words[1] = threads;
                    }
        });
    const double asked = 0.8 * trial.request.cores;
    trial.line(
        {false, "step 8: all cores against one", "", "at least " + number(asked) + " times as fast",
         "Are the tiles or rows small enough that no thread waits long for the last one? Is "
         "there a lock that makes threads wait?"},
        [&](JudgedLine& line) {
            // Without --threads, the program uses all cores.
            const std::vector<std::string> one{"--threads", "1"}, all;
            const std::string scene = long_enough({trial.own, one}, trial.request.seed, Clock::wall,
                                                  0.5, trial.request.crowd);
            line.looked = {scene, {}, {}, {}};
            // A program that is fast enough once is fast enough. It gets another chance if the
            // machine was busy, or if the program is so near that chance may have decided.
            for (int attempt = 0; attempt < 3 && !line.passed; ++attempt) {
                const Turns mine =
                    in_turns({trial.own, one}, {trial.own, all}, scene, Clock::wall, 5, asked);
                line.passed = mine.ratio >= asked;
                line.actual = times_as_fast(mine);
                if (line.passed) {
                    line.busy_machine = false;
                    return;
                }
                // Is the program slow, or is the machine busy with other things?
                const Turns ours = in_turns({trial.reference, one}, {trial.reference, all}, scene,
                                            Clock::wall, 5, asked);
                line.busy_machine = ours.ratio < asked;
                line.passed = mine.ratio >= 0.9 * ours.ratio;
                line.actual += "; our program is " + number(ours.ratio) + " times as fast here";
                if (!line.busy_machine && mine.ratio < 0.75 * ours.ratio) break;
            }
            if (line.busy_machine) line.actual += ", so this machine is busy";
        });
}

void judge_tree(const Trial& trial) {
    trial.line(
        {false, "step 9: --list draws the same bytes", "", "the same bytes",
         "A box that is too small loses spheres; of equally near spheres, the last one in the "
         "file counts."},
        [&](JudgedLine& line) {
            look_at_list(trial, {"", crowd_with_twins(trial.request.seed, 64, 36), ""}, line);
        });
    trial.line(
        {false, "step 9: the tree against --list", "",
         "at least " + number(trial.request.tree_gain, "%.0f") +
             " times as fast, in processor time",
         "Is the tree searched without --list, and the list with it? Do you skip everything in a "
         "box if the ray misses the box or has already hit something nearer than the box? "
         "std::fmin and std::fmax are slow; std::min and std::max are not."},
        [&](JudgedLine& line) {
            look_at_tree(trial, 1.5, 16, crowds(trial.request.seed, 10'000), line);
        });
}

void judge_mesh_tree(const Trial& trial) {
    trial.line(
        {false, "step 10: --list draws the same bytes", "", "the same bytes",
         "The box of a triangle must hold its three corners, with a margin for rounding errors."},
        [&](JudgedLine& line) { look_at_list(trial, fine_mesh(trial.request.seed, 48), line); });
    trial.line({false, "step 10: the tree against --list", "",
                "at least " + number(trial.request.tree_gain, "%.0f") +
                    " times as fast, in processor time, for 10,000 triangles",
                "Are the triangles of a mesh in the tree, as the spheres are?"},
               [&](JudgedLine& line) {
                   // In a run of a second, the time for reading the file hardly matters.
                   const auto scene_of = [&](int width) {
                       return fine_mesh(trial.request.seed, width);
                   };
                   look_at_tree(trial, 1, 48, scene_of, line);
               });
}

void judge_list(const Trial& trial) {
    trial.line({false, "list: --list against ours", "",
                "at most 4 times our processor time, because compared with a slow list, any tree "
                "looks fast",
                "With --list, test every sphere once per ray, and do nothing else."},
               [&](JudgedLine& line) {
                   const std::vector<std::string> list{"--list", "--threads", "1"};
                   const Turns turns =
                       in_turns({trial.own, list}, {trial.reference, list},
                                crowd(trial.request.seed, 96, 54), Clock::processor, 3, 4);
                   line.passed = turns.ratio <= 4;
                   line.actual = number(turns.ratio) + " times (" + number(turns.first, "%.2f s") +
                                 ", " + number(turns.second, "%.2f s") + ")";
               });
}

}  // namespace companion
