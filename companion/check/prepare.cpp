#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/platform.hpp>
#include <chrono>
#include <companion/build/build.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/build/turn.hpp>
#include <companion/check/known_mistakes.hpp>
#include <companion/check/prepare.hpp>
#include <companion/model/route.hpp>
#include <companion/system/background.hpp>
#include <companion/system/files.hpp>
#include <companion/system/platform.hpp>
#include <cstdio>
#include <set>
#include <sstream>
#include <thread>

namespace companion {
namespace {

using IsOver = std::function<bool()>;

fs::path lock_file(const Course& course) {
    return private_folder(course) / "building-ahead.lock";
}

// While one of these exists, something is being built ahead.
class Sign {
  public:
    explicit Sign(const Course& course) : file_{ahead_file(course)} {
        app::replace_file(file_, "what all checks need");
    }
    ~Sign() {
        std::error_code gone;
        fs::remove(file_, gone);
    }
    Sign(const Sign&) = delete;
    Sign& operator=(const Sign&) = delete;

  private:
    fs::path file_;
};

// The exercises for which everything was built, or tried in vain.
class Prepared {
  public:
    explicit Prepared(const Course& course) : file_{course.build / "prepared"} {
        // When the companion is built again, what was built before may be out of date.
        const auto stamp = last_written(course.build / "course.stamp");
        const auto written = last_written(file_);
        if (!written || (stamp && *stamp > *written)) return;
        std::istringstream lines{read_text(file_)};
        for (std::string id; std::getline(lines, id);) ids_.insert(id);
    }
    bool has(const Exercise& exercise) const { return ids_.count(exercise.id) > 0; }
    void add(const Exercise& exercise) {
        ids_.insert(exercise.id);
        std::string text;
        for (const std::string& id : ids_) text += id + '\n';
        app::replace_file(file_, text);
    }

  private:
    fs::path file_;
    std::set<std::string> ids_;
};

void build_step(const Course& course, const std::vector<std::string>& targets) {
    const BuildResult result = build_in_turn(course, targets);
    if (result.ok) return;
    const std::string error = first_error(course, result.output);
    throw app::Failure(targets[0] + " cannot be built: " +
                       (error.empty() ? result.output : error).substr(0, error.find('\n')));
}

// Takes a turn for each step, so that a check waits for one step at most.
void build_ahead(const Course& course, const std::vector<Exercise>& some,
                 const std::function<void(const std::string&)>& tell, const IsOver& is_over) {
    Prepared prepared{course};
    const auto step = [&](const std::string& what, const auto& work) {
        const StepAhead turn{course, what, is_over};
        const EndsRuns ends{is_over};
        if (turn.has_begun()) work(turn);
    };
    tell("what all checks need");
    step("what all checks need", [&](const StepAhead&) { build_step(course, {"check_runtime"}); });
    for (const Exercise& exercise : some) {
        if (prepared.has(exercise)) continue;
        const std::string what = "the test cases of " + exercise.id;
        tell(what);
        std::vector<std::string> targets{"check." + exercise.id};
        if (exercise.chapter.uses_real) targets.push_back(targets[0] + ".float");
        step(what, [&](const StepAhead&) { build_step(course, targets); });
    }
    for (const Exercise& exercise : some) {
        if (prepared.has(exercise)) continue;
        const std::string what = "the known mistakes of " + exercise.id;
        std::vector<Mistake> left = mistakes_without_signature(course, exercise);
        if (!left.empty()) tell(what);
        for (; !left.empty() && !is_over(); left = mistakes_without_signature(course, exercise))
            step(what, [&](const StepAhead& turn) {
                const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
                left.resize(std::min(cores, left.size()));
                // They can be tried again later: nobody needs to wait for them.
                const IsOver ends_early = [&] { return is_over() || turn.is_wanted(); };
                const EndsRuns ends{ends_early};
                const double patience = 5 * course.patience;  // others may keep the cores busy
                find_signatures(
                    course, exercise, left, patience, [](const Mistake&, const Signature&) {},
                    ends_early);
            });
        if (!is_over()) prepared.add(exercise);
    }
}

}  // namespace

std::vector<Exercise> next_exercises(const Course& course, const std::string& after) {
    const State state = read_state(course);
    std::vector<Exercise> next;
    const auto first = next_on_route(course, after);
    bool begins = false;
    for (const Step& step : route(course)) {
        begins = begins || (first && step.id() == first->id());
        if (begins && step.exercise && is_open(course, state, step)) next.push_back(*step.exercise);
        if (next.size() == 2) break;
    }
    return next;
}

void prepare(const Course& course, const std::vector<Exercise>& some,
             const std::function<void(const std::string&)>& tell) {
    end_preparing(course);
    const FileLock one_at_a_time{lock_file(course)};
    const Sign sign{course};
    build_ahead(course, some, tell, [] { return false; });
}

bool prepare_in_background(const Course& course, const std::vector<Exercise>& some) {
    if (!app::is_terminal(stdin) || !app::is_terminal(stdout)) return false;
    const Prepared prepared{course};
    if (std::all_of(some.begin(), some.end(),
                    [&](const Exercise& exercise) { return prepared.has(exercise); }))
        return true;
    return in_background([&](const IsOver& is_closed) {
        const FileLock lock{lock_file(course), Hold::alone, [] { return false; }};
        if (!lock.is_held()) return;
        const Sign sign{course};
        const IsOver is_over = [&] { return is_closed() || !fs::exists(ahead_file(course)); };
        try {
            build_ahead(
                course, some, [](const std::string&) {}, is_over);
        } catch (const std::exception&) {
            // The check itself will report what is wrong. Until something changes, it is not tried
            // again.
            Prepared tried{course};
            for (const Exercise& exercise : some)
                if (!is_over()) tried.add(exercise);
        }
    });
}

void end_preparing(const Course& course) {
    for (;;) {
        std::error_code gone;
        fs::remove(ahead_file(course), gone);
        const FileLock lock{lock_file(course), Hold::alone, [] { return false; }};
        if (lock.is_held()) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

}  // namespace companion
