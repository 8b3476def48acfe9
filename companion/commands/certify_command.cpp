#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/build/side_build.hpp>
#include <companion/build/turn.hpp>
#include <companion/check/passing_chapters.hpp>
#include <companion/check/sanitized.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/compared_picture.hpp>
#include <companion/commands/judged_lines.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/model/progress.hpp>
#include <companion/own/standing.hpp>
#include <companion/pages/certificate.hpp>
#include <companion/pages/studies.hpp>
#include <companion/system/date.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>
#include <ctime>
#include <rt/counted.hpp>
#include <set>
#include <sstream>

namespace companion {
namespace {

constexpr double patience = 120;  // seconds for a program's tests or measurements

std::string compiler(const Course& course) {
    const Result result =
        run_process({.command = {cached(course, "CMAKE_CXX_COMPILER"), "--version"}});
    return result.ok() ? result.output.substr(0, result.output.find_first_of("\r\n"))
                       : "unknown compiler";
}

// "core passes, 2 stars open".
std::string stand_of(const Checked& checked) {
    if (checked.tests().empty()) return "not written";
    if (const Passed* const passed = checked.passed(); passed && !passed->open_stars.empty())
        return "core passes, " + stars_open(static_cast<int>(passed->open_stars.size()));
    return std::to_string(checked.passed_cases()) + " of " +
           std::to_string(checked.tests().size()) + " test cases pass";
}

// Fills the certificate and shows each line as soon as it is known.
class Examination {
  public:
    explicit Examination(const Course& course) : course_{course} {
        certificate_.date = date_of(std::time(nullptr));
        certificate_.machine = machine();
        certificate_.compiler = compiler(course);
    }

    Certificate certificate() const { return certificate_; }

    void note(const CertifiedFigure& one) {
        certificate_.measurements.push_back(one);
        const std::string line = line_of(one);
        std::puts((one.held != Held::fails ? line : one.star ? yellow(line) : red(line)).c_str());
        std::fflush(stdout);
    }
    void note(bool holds, const std::string& exercise, const std::string& what,
              const std::string& figure, const std::string& bound, bool star = false) {
        note({holds ? Held::holds : Held::fails, exercise, what, figure, bound, star});
    }

    // Checks the exercises of these chapters and adds their lines. True when all exercises are
    // written.
    bool check_exercises_of(const std::vector<CheckedChapter>& all) {
        bool written = true;
        for (const CheckedChapter& one : all) {
            std::string first;
            for (const Checked& checked : one.exercises) {
                if (checked.exercise.is_star()) continue;
                written = written && !checked.is<NotBegun>() && !checked.is<Begun>() &&
                          !checked.is<Waiting>();
                if (first.empty() && !checked.passed()) first = checked.exercise.id;
            }
            note(one.passes(), first, "checkpoints of " + one.chapter.name, one.why(), "all pass");
            note_stars(one);
        }
        return written;
    }

    // Adds the electives' lines, which are only for information. Builds only the exercises that are
    // begun.
    void show_electives() {
        const State state = read_state(course_);
        for (const Chapter& chapter : chapters(course_)) {
            if (chapter.core) continue;
            std::vector<Exercise> begun = exercises(course_, chapter);
            const std::size_t all = begun.size();
            std::erase_if(begun, [&](const Exercise& exercise) {
                return progress_of(course_, state, exercise) == Progress::to_write;
            });
            if (begun.empty()) continue;
            const std::vector<Checked> checked = check_exercises(course_, begun);
            const auto passed = std::count_if(checked.begin(), checked.end(),
                                              [](const Checked& one) { return one.passed(); });
            note({Held::shows, "", "checkpoints of " + chapter.name + ", an elective",
                  std::to_string(passed) + " of " + std::to_string(all) + " exercises pass", ""});
        }
    }

    // The verdict on the learner's own program. If it passed before, it is judged once more, on
    // different scenes.
    void judge_own_again() {
        const auto task = chapter_of_task(course_);
        if (!task) return;
        OwnRecord own = read_state(course_).own;
        if (own_passes(own)) {
            print("Judging your own ray tracer again takes a few minutes.\n");
            JudgedLines lines{course_,
                              (fs::path{own.folder} / program_name("own")).generic_string()};
            judge_own(course_, own.folder, scenes_seed({}), "", lines);
            own = read_state(course_).own;
        }
        note(own_passes(own), task->number(), "a ray tracer from an empty folder, judged",
             standing_of(own), "steps 1 to 6 pass");
        note(own_stars_pass(own), task->number(), "the rest of its verdict", standing_of(own),
             "every line passes", true);
    }

    // Collects the proofs for the eight questions, once all lines are known.
    void prove(const std::vector<CheckedChapter>& all) {
        for (const Ability& ability : self_assessment()) {
            Proof proof{ability.words, {}};
            for (const CheckedChapter& chapter : all)
                for (const Checked& checked : chapter.exercises)
                    if (is_in(checked.exercise.id, ability.exercises))
                        proof.lines.push_back({checked.passed() ? Held::holds : Held::fails,
                                               checked.exercise.id, checked.exercise.title,
                                               stand_of(checked), ""});
            for (const CertifiedFigure& line : certificate_.measurements)
                if (is_in(line.exercise, ability.exercises) &&
                    line.what.rfind("checkpoints of ", 0) != 0)
                    proof.lines.push_back(line);
            certificate_.proofs.push_back(proof);
        }
    }

    // Builds all of the learner's code from scratch with -O3; every warning about a file in
    // exercises/ counts.
    void build_with_warnings(const std::vector<Chapter>& all) {
        std::error_code held;  // a virus scanner may hold a program
        fs::remove_all(course_.build / "certify", held);
        std::string folders;
        for (const Chapter& chapter : all)
            folders += (course_.root / "exercises" / chapter.name).generic_string() + ';';
        fast_ = side_build(
            course_, "certify",
            {"-DCMAKE_BUILD_TYPE=Release", "-DCOURSE_YOURS=" + folders, "-DRT_WERROR=OFF"});
        std::vector<std::string> targets;
        for (const Chapter& chapter : all) {
            targets.push_back(chapter.name + "_mine");
            if (is_measured(chapter)) targets.push_back("certify." + chapter.name);
        }
        const BuildResult result = build(fast_, targets);
        std::set<std::string> warnings;
        std::istringstream in{result.output};
        for (std::string line; std::getline(in, line);)
            if (line.find("warning: ") != std::string::npos &&
                line.find("exercises/") != std::string::npos)
                warnings.insert(line.substr(line.find("exercises/")));
        for (const std::string& warning : warnings) note(false, "", warning, "", "");
        if (!result.ok) note(false, "", first_error(course_, result.output), "", "compiles");
        note(result.ok && warnings.empty(), "", "builds with -O3 -Wall -Wextra -Wpedantic -Wshadow",
             rt::counted(warnings.size(), "warning"), "none");
    }

    // Runs the checkpoints under the address and undefined-behavior sanitizers.
    void check_memory(const std::vector<Chapter>& all) {
        if (const std::string why = instead_of_sanitizers(); !why.empty()) {
            note({Held::shows, "", "memory and undefined behavior", why, ""});
            return;
        }
        const Course checked =
            side_build(course_, "certify-memory",
                       {"-DCMAKE_BUILD_TYPE=Debug", "-DRT_SANITIZE=address,undefined",
                        "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1"});
        std::vector<std::string> targets;
        for (const Chapter& chapter : all) targets.push_back(chapter.name + "_checkpoint");
        const BuildResult built = build(checked, targets);
        if (!built.ok) note(false, "", first_error(course_, built.output), "", "compiles");
        for (const Chapter& chapter : all) {
            const std::string what = "memory and undefined behavior, " + chapter.name;
            for (const bool star : {false, true}) {
                std::string found;
                for (const Exercise& exercise : exercises(course_, chapter)) {
                    const Result result = run_process(
                        {.command = command_of(
                             checked, {.exercise = exercise.id,
                                       .part = star ? Cases::Part::stars : Cases::Part::core}),
                         .timeout = patience});
                    if (found.empty()) found = sanitizer_report(chapter, result.output);
                    if (found.empty() && !result.ok())
                        found = exercise.id + ": " + how_it_ended(result);
                }
                note(found.empty(), "", what, found.empty() ? "clean" : found, "clean", star);
            }
        }
    }

    void measure(const std::vector<Chapter>& all) {
        for (const Chapter& chapter : all) {
            if (!is_measured(chapter)) continue;
            const Result result =
                run_process({.command = {fast_.program("certify." + chapter.name).string()},
                             .output = Output::errors_shown,
                             .timeout = patience});
            for (const CertifiedFigure& one : read_measurements(result.output)) note(one);
            const bool ended = !result.timed_out && !result.signal && result.exit_code != 127;
            if (!ended) note(false, "", "measuring " + chapter.name, how_it_ended(result), "ends");
        }
    }

    void draw(const std::vector<Chapter>& all) {
        const fs::path folder = course_.out() / "certificate";
        app::make_folder(folder);
        for (const Chapter& chapter : all) {
            fs::remove(folder / chapter.picture());
            const Result result =
                run_process({.command = {fast_.program(chapter.name + "_mine").string(), "--quiet",
                                         "--out", (folder / chapter.picture()).string()},
                             .timeout = 900});
            char seconds[32];
            std::snprintf(seconds, sizeof seconds, "%.1f s, ", result.seconds);
            const auto [is_right, words] = compared(chapter);
            note(result.ok() && is_right, "", "picture of " + chapter.name + ", all your code",
                 result.ok() ? seconds + words : how_it_ended(result), "the solution's");
            if (result.ok() && is_right)
                certificate_.pictures.push_back("certificate/" + chapter.picture());
        }
    }

  private:
    void note_stars(const CheckedChapter& one) {
        std::size_t stars = 0, open = 0;
        for (const Checked& checked : one.exercises) {
            if (const Passed* const passed = checked.passed()) {
                stars += static_cast<std::size_t>(passed->stars);
                open += passed->open_stars.size();
            } else if (checked.exercise.is_star()) {
                ++stars, ++open;
            }
        }
        if (one.passes())
            note(open == 0, "", "stars of " + one.chapter.name,
                 std::to_string(stars - open) + " of " + std::to_string(stars), "all", true);
    }
    // Whether a chapter's picture is the solution's, and in words.
    std::pair<bool, std::string> compared(const Chapter& chapter) const try {
        const ComparedPicture picture = compare_picture(course_, chapter);
        if (picture.found.bit_for_bit) return {true, "bit for bit the same as the solution's"};
        if (picture.found.same) return {true, "the same as the solution's within the noise"};
        if (picture.is_right())
            return {true, "differs, as it may with open stars or other right answers"};
        return {false, "differs from the solution's: ./course compare " + chapter.number()};
    } catch (const app::Failure& failed) {
        return {false, failed.what()};
    }
    static bool is_in(const std::string& id, const std::vector<std::string>& ids) {
        return std::count(ids.begin(), ids.end(), id) > 0;
    }
    bool is_measured(const Chapter& chapter) const {
        return fs::exists(course_.root / "tests/certify" / (chapter.name + ".cpp"));
    }
    // What a sanitizer reports, with the line in the learner's code if there is one.
    std::string sanitizer_report(const Chapter& chapter, const std::string& output) const {
        std::vector<fs::path> files;
        for (const Exercise& exercise : exercises(course_, chapter))
            files.insert(files.end(), exercise.files.begin(), exercise.files.end());
        return to_text(read_sanitizer_report(output, files));
    }

    const Course& course_;
    Course fast_;
    Certificate certificate_;
};

}  // namespace

int certify(const Course& course, const Given&) {
    const Turn turn{course};  // nothing else may disturb what is measured
    app::make_folder(course.out());
    const std::vector<Chapter> all = core_chapters(course);
    Examination examination{course};
    const std::vector<CheckedChapter> checked = check_all_chapters(course);
    const bool written = examination.check_exercises_of(checked);
    examination.judge_own_again();
    examination.show_electives();
    if (written) {
        std::puts("Every exercise is written. Building them all from scratch takes a few minutes.");
        std::fflush(stdout);
        examination.build_with_warnings(all);
        examination.measure(all);
        examination.check_memory(all);
        examination.draw(all);
    }
    examination.prove(checked);
    const Certificate certificate = examination.certificate();
    app::replace_file(course.out() / "certificate.html", certificate_html(certificate));
    app::replace_file(certificate_file(course), to_text(certificate));
    if (certificate.passed()) {
        std::puts(certificate.passed_with_stars()
                      ? "Everything passes, core and stars. Your certificate is "
                        "out/certificate.html."
                      : "The core passes. Your certificate is out/certificate.html; it lists the "
                        "open stars.");
        return app::done;
    }
    std::puts("You are not there yet; out/certificate.html shows how far you are.");
    const auto is_missing = [](const CertifiedFigure& one) {
        return one.held == Held::fails && !one.star && !one.exercise.empty();
    };
    if (std::any_of(certificate.measurements.begin(), certificate.measurements.end(), is_missing))
        print(next_step(course, next_on_route(course)));
    return written ? app::could_not : app::still_to_write;
}

}  // namespace companion
