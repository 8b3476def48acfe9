#include <algorithm>
#include <app/cores.hpp>
#include <app/errors.hpp>
#include <companion/own/graft_judge.hpp>
#include <companion/own/own_program.hpp>
#include <companion/own/scenes.hpp>
#include <companion/own/tracer.hpp>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <rt/rng.hpp>

namespace companion {
namespace {

// The largest difference between two pixels in any channel, in byte values.
int difference(const Picture& picture, int x, int y, const Picture& other, int other_x,
               int other_y) {
    const auto at = [](const Picture& p, int column, int row) {
        return p.bytes.data() + 3 * (static_cast<long>(row) * p.width + column);
    };
    int most = 0;
    for (int channel = 0; channel < 3; ++channel)
        most = std::max(
            most, std::abs(at(picture, x, y)[channel] - at(other, other_x, other_y)[channel]));
    return most;
}

// The largest difference between neighbors among the pixels that are at most `reach` pixels from
// here.
int edge(const Picture& picture, int x, int y, int reach) {
    int most = 0;
    for (int row = std::max(0, y - reach); row <= std::min(picture.height - 2, y + reach); ++row)
        for (int column = std::max(0, x - reach); column <= std::min(picture.width - 2, x + reach);
             ++column)
            most = std::max({most, difference(picture, column, row, picture, column + 1, row),
                             difference(picture, column, row, picture, column, row + 1)});
    return most;
}

// The percentage of the outlines in one picture at which the other picture has none. Colors do not
// matter; learners choose their own.
double outlines_missing(const Picture& in, const Picture& from) {
    constexpr int outline = 28, nothing = 5;  // difference between neighbors, in byte values
    long all = 0, missing = 0;
    for (int y = 0; y + 1 < in.height; ++y)
        for (int x = 0; x + 1 < in.width; ++x)
            if (edge(in, x, y, 0) >= outline) {
                ++all;
                missing += edge(from, x, y, 1) <= nothing;
            }
    return all == 0 ? 0 : 100.0 * static_cast<double>(missing) / static_cast<double>(all);
}

// Judges pictures of the two balls of 00.1. The program reads no scene, but may get a position of
// the eye.
void look_at_outlines(const Course& course, const GraftRequest& request,
                      const std::vector<std::string>& words, JudgedLine& line) {
    const fs::path file = course.build / ("tracer." + request.chapter.number() + ".ppm");
    line.looked.words = words;
    const Picture mine =
                      draw_by_tracer(course, request.program, words, file, course.patience).picture,
                  ours = draw_by_tracer(course, request.reference, words, file, course.patience)
                             .picture;
    line.looked.pictures = compare_still(mine, ours);
    if (mine.width != ours.width || mine.height != ours.height) {
        line.actual = std::to_string(mine.width) + " x " + std::to_string(mine.height) + " pixels";
        line.expected = std::to_string(ours.width) + " x " + std::to_string(ours.height);
        return;
    }
    const double missing = outlines_missing(ours, mine), more = outlines_missing(mine, ours);
    line.passed = missing < 3 && more < 3;
    char text[120];
    std::snprintf(
        text, sizeof text,
        "%.0f %% of our outlines are missing from yours, and %.0f %% of yours are not in ours",
        missing, more);
    line.actual = line.passed ? "the same outlines" : text;
}

// "(102, 51, 204)"
std::string bytes_at(const Picture& picture, int x, int y) {
    const auto* const bytes = picture.bytes.data() + 3 * (static_cast<long>(y) * picture.width + x);
    return '(' + std::to_string(bytes[0]) + ", " + std::to_string(bytes[1]) + ", " +
           std::to_string(bytes[2]) + ')';
}

// Judges pictures without noise. A few pixels on outlines may differ, because they may be rounded
// to the other side.
void look_at_still(const OwnProgram& own, const OwnProgram& ours, const OwnScene& scene,
                   JudgedLine& line) {
    line.looked = {scene.text, scene.mesh, {}, {}};
    const Picture mine = own.picture(scene.text, {}).picture,
                  wanted = ours.picture(scene.text, {}).picture;
    line.looked.pictures = compare_still(mine, wanted);
    if (mine.width != wanted.width || mine.height != wanted.height) {
        line.actual = "a picture of a different size from what the scene asks for";
        return;
    }
    long differing = 0;
    int most = 0;
    std::string where;
    for (int y = 0; y < mine.height; ++y)
        for (int x = 0; x < mine.width; ++x) {
            const int here = difference(mine, x, y, wanted, x, y);
            differing += here > 2;
            if (here <= most) continue;
            most = here;
            where = "column " + std::to_string(x) + " of row " + std::to_string(y) + " is " +
                    bytes_at(mine, x, y) + ", not " + bytes_at(wanted, x, y);
        }
    line.passed = 500 * differing <= mine.pixels();
    line.actual = differing == 0 ? "the same picture"
                                 : std::to_string(differing) + " of " +
                                       std::to_string(mine.pixels()) + " pixels differ: " + where;
}

}  // namespace

void judge_graft(const Course& course, const GraftRequest& request,
                 const std::function<void(const JudgedLine&)>& report) {
    const Graft& graft = *request.chapter.graft;
    // Returns whether the line passes; one that is not asked for does.
    const auto judge = [&](JudgedLine line, const std::function<void(JudgedLine&)>& look) {
        if (!request.only_line.empty() && line.what != request.only_line) return true;
        request.begins(line.what);
        try {
            look(line);
        } catch (const app::Failure& failure) {
            line.actual = failure.what();
        }
        report(line);
        return line.passed;
    };
    for (const std::string& header : graft.headers)
        if (!std::count(request.headers.begin(), request.headers.end(), header))
            report({false, "#include <rt/" + header + ">", "tracer.cpp does not include it",
                    "#include of your own header, or of one that includes it, in place of the old "
                    "code",
                    ""});
    if (graft.reads == Graft::Reads::nothing)
        judge({false, "the picture of 00.1", "", "the same outlines of ball, ground and shadow",
               "Leave the eye, the balls and the light where they were."},
              [&](JudgedLine& line) { look_at_outlines(course, request, {}, line); });
    if (graft.reads == Graft::Reads::eye) {
        rt::Rng random{request.seed, 1};
        const char* const about_the_eye =
            "Set eye from words[1], words[2] and words[3] before you make the camera. It looks at "
            "the ball's center, (0, 0, -4), with y up and a vertical field of view of radians(50). "
            "Call primary_ray for the ray through the pixel's middle.";
        bool all_pass = true;  // no suggestion has been given yet
        for (int i = 0; i < 3; ++i) {
            std::vector<std::string> eye;
            for (const auto& [low, high] : {std::pair{-4.0, 4.0}, {0.2, 3.0}, {-1.0, 2.0}})
                eye.push_back(std::to_string(low + (high - low) * random.uniform()));
            all_pass &= judge(
                {false, "eye " + std::to_string(i + 1) + " of 3", "",
                 "the same outlines of ball, ground and shadow", all_pass ? about_the_eye : ""},
                [&](JudgedLine& line) {
                    look_at_outlines(course, request, eye, line);
                    line.actual =
                        "called with " + eye[0] + ' ' + eye[1] + ' ' + eye[2] + ": " + line.actual;
                });
        }
    }
    if (graft.reads != Graft::Reads::scene) return;
    const OwnProgram own{OwnProgram::Existing{}, request.program};
    if (graft.still) {
        const OwnProgram ours{OwnProgram::Existing{}, request.reference};
        for (const TaskStep& step : task_steps(request.seed))
            if (std::count(graft.steps.begin(), graft.steps.end(), step.number))
                for (const OwnScene& scene : step.scenes)
                    judge(
                        {false, scene.name, "", "our picture",
                         (step.number == 1 ? ""
                                           : "Does `color` change where a sphere is hit? "
                                             "(`Color color` there would be a second variable.) ") +
                             scene.suggestion},
                        [&](JudgedLine& line) { look_at_still(own, ours, scene, line); });
        const OwnScene lit = lit_balls(request.seed);
        judge({false, lit.name, "", "our picture", lit.suggestion},
              [&](JudgedLine& line) { look_at_still(own, ours, lit, line); });
        return;
    }
    std::vector<std::string> parts;
    for (const int step : graft.steps) parts.push_back("step" + std::to_string(step));
    JudgeRequest asked{{}, request.reference, request.seed, {}, app::physical_cores()};
    asked.crowd = 300;    // so that a program without a tree also ends soon
    asked.tree_gain = 5;  // chapter 03's list is fast, so the gain is smaller
    asked.only_line = request.only_line;
    asked.begins = request.begins;
    judge_program(own, asked, parts, report);
}

}  // namespace companion
