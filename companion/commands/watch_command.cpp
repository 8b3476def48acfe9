#include <algorithm>
#include <app/errors.hpp>
#include <app/platform.hpp>
#include <chrono>
#include <companion/build/turn.hpp>
#include <companion/check/check.hpp>
#include <companion/check/prepare.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/commands/shown_verdict.hpp>
#include <companion/model/progress.hpp>
#include <companion/system/keyboard.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <csignal>
#include <cstdio>
#include <map>
#include <optional>
#include <thread>

namespace companion {
namespace {

constexpr int pause_ms = 100;  // between two looks at the files

// When each file was last written; a file is absent while an editor replaces it.
using Written = std::map<fs::path, std::int64_t>;

Written written(const Course& course, const std::vector<Exercise>& all) {
    Written times;
    for (const Exercise& exercise : all)
        for (const fs::path& file : exercise.files)
            if (const auto time = last_written(course.root / file)) times[file] = *time;
    return times;
}

class Watch {
  public:
    // Starts at the exercise with this index.
    Watch(const Course& course, std::vector<Exercise> all, std::size_t first)
        : course_{course},
          all_{std::move(all)},
          current_{first},
          on_terminal_{app::is_terminal(stdin) && app::is_terminal(stdout)},
          keyboard_{on_terminal_} {}

    ~Watch() {
        if (preparing_.joinable()) preparing_.join();
    }

    int run() {
        seen_ = written(course_, all_);
        go_on();
        for (;;) {
            while (!has_changed()) {
                const auto key = keyboard_.key(pause_ms);
                if (key && !obey(*key)) return app::done;
                if (keyboard_.at_end()) return end_of_input();
            }
            if (check_current()) go_on();
        }
    }

  private:
    // Finds the next exercise that does not pass, from the current one on, and says what to do. An
    // exercise that is already written is checked first, and skipped if it passes. If all pass, the
    // current one stays current, for its stars.
    void go_on() {
        for (;;) {
            const State state = read_state(course_);
            const auto is_open = [&](const Exercise& exercise) {
                return !passes(progress_of(course_, state, exercise));
            };
            auto next =
                std::find_if(all_.begin() + static_cast<long>(current_), all_.end(), is_open);
            if (next == all_.end()) next = std::find_if(all_.begin(), all_.end(), is_open);
            if (next == all_.end()) {
                print('\n' + next_step(course_, next_on_route(course_)));
                print_keys();
                return;
            }
            current_ = static_cast<std::size_t>(next - all_.begin());
            if (progress_of(course_, state, *next) == Progress::to_write) {
                const auto step = next_on_route(course_);
                if (step && !step->exercise)  // a graft, which is checked elsewhere
                    print('\n' + next_step(course_, step) + "\nThen, in this window:");
                print('\n' + next_step(course_, *next));
                print_keys();
                prepare();
                return;
            }
            if (!check_current()) return;
        }
    }

    // True if a file has changed; its exercise then becomes the current one.
    bool has_changed() {
        Written now = written(course_, all_);
        if (now == seen_) return false;
        // An editor may not have finished writing.
        for (Written later; later != now;) {
            if (!later.empty()) now = later;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            later = written(course_, all_);
        }
        // An editor may have removed a file in order to write it anew.
        const auto is_gone = [&](const auto& file) { return !now.count(file.first); };
        for (int i = 0; i < 10 && std::any_of(seen_.begin(), seen_.end(), is_gone); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
            now = written(course_, all_);
        }
        const auto differs = [&](const fs::path& file) {
            return now.count(file) != seen_.count(file) ||
                   (now.count(file) && seen_.at(file) != now.at(file));
        };
        const auto is_touched = [&](const Exercise& exercise) {
            return std::any_of(exercise.files.begin(), exercise.files.end(), differs);
        };
        bool found = is_touched(all_[current_]);
        for (std::size_t i = 0; !found && i < all_.size(); ++i)
            if (is_touched(all_[i])) {
                current_ = i;
                found = true;
            }
        seen_ = now;
        return found;
    }

    // Returns whether the current exercise passes.
    bool check_current() {
        if (on_terminal_) print("\033[2J\033[H");
        if (preparing_.joinable()) preparing_.join();
        const std::string stars_command = "./course check " + all_[current_].id + " --stars";
        std::optional<Turn> turn;
        std::vector<Checked> checked;
        std::string trouble;
        try {
            turn.emplace(course_);
            std::optional<WaitingLine> waiting{"checking " + all_[current_].id};
            checked = check_exercises(course_, {all_[current_]}, [&](const auto& in_double) {
                waiting.reset();
                print(summary_line(in_double[0], stars_command));
            });
        } catch (const app::Failure& failure) {
            trouble = failure.what();
        }
        if (!trouble.empty()) {
            print("course: " + trouble + '\n');
            print_keys();
            return false;
        }
        print(float_lines(checked, stars_command));
        const auto is_saved_again = [&] { return written(course_, all_) != seen_; };
        const EndsRuns ends{is_saved_again};
        if (checked[0].passed()) {
            print_chapter_end();
            return true;
        }
        print_details(course_, checked[0], is_saved_again);
        print_keys();
        return false;
    }

    void print_chapter_end() const {
        const Chapter& chapter = all_[current_].chapter;
        if (!first_open(course_, read_state(course_), exercises(course_, chapter)))
            print('\n' + chapter_done(chapter, open_stars_of(course_, chapter)));
    }

    // Obeys a key. Returns false if the learner quits.
    bool obey(char key) {
        const Exercise& exercise = all_[current_];
        const std::string number = exercise.chapter.number();
        switch (key) {
            case 'q':
                return false;
            case 'h':
                call({"hint", exercise.id});
                break;
            case 'r':
                call({"run", number});
                break;
            case 'c':
                call({"compare", number});
                break;
            case 'l':
                call({"list"});
                break;
            case 'n':
                next_exercise();
                break;
            default:
                return true;
        }
        return true;
    }

    // Runs a command of the companion in a separate process, so that an error in it does not end
    // this one.
    void call(std::vector<std::string> command) {
        command.insert(command.begin(), course_.program("course").string());
        if (on_terminal_) print("\n");
        const Result result = run_process(
            {.command = std::move(command), .output = Output::shown, .passes_signals = true});
        if (result.passed_on) std::raise(result.passed_on);
        print_keys();
    }

    void next_exercise() {
        const State state = read_state(course_);
        for (std::size_t step = 1; step <= all_.size(); ++step) {
            const std::size_t i = (current_ + step) % all_.size();
            if (passes(progress_of(course_, state, all_[i]))) continue;
            current_ = i;
            break;
        }
        print('\n' + next_step(course_, all_[current_]));
        print_keys();
        prepare();
    }

    // Prepares the check of the current exercise, and of the one after it, in the background, while
    // the learner reads and writes.
    void prepare() {
        std::vector<Exercise> some{all_[current_]};
        for (Exercise& next : next_exercises(course_, some[0].id))
            if (next.id != some[0].id && some.size() < 2) some.push_back(std::move(next));
        if (prepare_in_background(course_, some)) return;
        if (preparing_.joinable()) preparing_.join();
        preparing_ = std::thread{[this, exercise = all_[current_]] {
            try {
                prepare_check(course_, exercise);
            } catch (const std::exception&) {
                // The check itself will report what is wrong.
            }
        }};
    }

    void print_keys() const {
        print(dim("\nh hint   r run   c compare   l list   n next   q quit   (watching " +
                  all_[current_].id + ": save a file to check it)\n"));
    }

    int end_of_input() const {
        return first_open(course_, read_state(course_), all_) ? app::still_to_write : app::done;
    }

    const Course& course_;
    std::vector<Exercise> all_;
    std::size_t current_;
    bool on_terminal_;
    Keyboard keyboard_;
    Written seen_;
    std::thread preparing_;
};

}  // namespace

int watch(const Course& course, const Given& given) {
    std::vector<Exercise> all = exercises_on_route(course);
    std::optional<Chapter> chapter;
    if (given.named) chapter = find_chapter(course, *given.named);
    // An elective is watched only if its chapter is named.
    if (chapter && !chapter->core)
        for (Exercise& exercise : exercises(course, *chapter)) all.push_back(std::move(exercise));
    std::size_t first = 0;
    if (chapter)
        while (first < all.size() && all[first].chapter.name != chapter->name) ++first;
    return Watch{course, std::move(all), first}.run();
}

}  // namespace companion
