#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <app/platform.hpp>
#include <chrono>
#include <companion/build/turn.hpp>
#include <companion/check/check.hpp>
#include <companion/check/counts.hpp>
#include <companion/check/prepare.hpp>
#include <companion/check/verdict_text.hpp>
#include <companion/commands/commands.hpp>
#include <companion/commands/next_step.hpp>
#include <companion/commands/shown_verdict.hpp>
#include <companion/live/page.hpp>
#include <companion/model/progress.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/keyboard.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace companion {
namespace {

constexpr int pause_ms = 100;  // between two looks at the files

// When each file was last written; a file is absent while an editor replaces it.
using Written = std::map<fs::path, std::int64_t>;

Written written(const Course& course, const std::vector<Exercise>& all) {
    Written times;
    const auto look = [&](const fs::path& file) {
        if (const auto time = last_written(course.root / file)) times[file] = *time;
    };
    for (const Exercise& exercise : all)
        for (const fs::path& file : exercise.files) look(file);
    look(tracer_file(course));
    look(tracer_scene(course));
    return times;
}

class Watch {
  public:
    // Starts at the exercise with this index.
    Watch(const Course& course, std::vector<Exercise> all, std::size_t first, LivePage* page)
        : course_{course},
          all_{std::move(all)},
          current_{first},
          page_{page},
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
                const auto key = next_key();
                if (key && !obey(*key)) return app::done;
                if (keyboard_.at_end()) return end_of_input();
                if (!key && page_ && page_->has_work()) work_for_page();
            }
            if (tracer_has_changed_)
                judge_tracer();
            else if (check_current())
                go_on();
        }
    }

  private:
    // Finds the next exercise that does not pass, from the current one on, and says what to do, on
    // the page alone if the terminal has said it. An exercise that is already written is checked
    // first, and skipped if it passes. If all pass, the current one stays current, for its stars.
    void go_on(bool is_said = false) {
        for (;;) {
            const State state = read_state(course_);
            const auto is_open = [&](const Exercise& exercise) {
                return !passes(progress_of(course_, state, exercise));
            };
            auto next =
                std::find_if(all_.begin() + static_cast<long>(current_), all_.end(), is_open);
            if (next == all_.end()) next = std::find_if(all_.begin(), all_.end(), is_open);
            if (next == all_.end()) {
                tell_next(next_step(course_, next_on_route(course_)), is_said);
                return;
            }
            current_ = static_cast<std::size_t>(next - all_.begin());
            if (progress_of(course_, state, *next) == Progress::to_write) {
                const auto step = next_on_route(course_);
                std::string words = next_step(course_, *next);
                std::optional<Chapter> graft;
                if (step && !step->exercise) {
                    graft = step->chapter;
                    words = next_step(course_, step) + "\nThen:\n" + words;
                }
                tell_next(words, is_said, graft);
                prepare();
                return;
            }
            if (!check_current()) return;
        }
    }

    // True if a file has changed: the tracer's, or one of an exercise, which then becomes the
    // current one.
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
        tracer_has_changed_ = differs(tracer_file(course_)) || differs(tracer_scene(course_));
        bool found = is_touched(all_[current_]) || tracer_has_changed_;
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
        forget_counts(course_);
        if (page_) page_->begin(all_[current_], next_step(course_, all_[current_]));
        const bool passes = tell_verdict();
        if (page_) page_->end();
        return passes;
    }

    bool tell_verdict() {
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
                say(summary_line(in_double[0], stars_command));
            });
        } catch (const app::Failure& failure) {
            trouble = failure.what();
        }
        if (!trouble.empty()) {
            say("course: " + trouble + '\n');
            print_keys();
            return false;
        }
        say(float_lines(checked, stars_command));
        const auto is_saved_again = [&] { return written(course_, all_) != seen_; };
        const EndsRuns ends{is_saved_again};
        if (checked[0].passed()) {
            print_chapter_end();
            return true;
        }
        print_details(course_, checked[0], is_saved_again,
                      [this](const std::string& text) { say(text); });
        print_keys();
        return false;
    }

    void print_chapter_end() {
        const Chapter& chapter = all_[current_].chapter;
        if (!first_open(course_, read_state(course_), exercises(course_, chapter)))
            say('\n' + chapter_done(chapter, open_stars_of(course_, chapter)));
    }

    // Compiles and draws the learner's tracer, and judges its graft if that comes next.
    void judge_tracer() {
        if (on_terminal_) print("\033[2J\033[H");
        if (preparing_.joinable()) preparing_.join();
        std::error_code none;  // pictures of an earlier tracer
        for (const char* name : {"tracer.ppm", "tracer_ours.ppm"})
            fs::remove(course_.out() / name, none);
        if (page_) page_->begin_tracer();
        {
            const Overhears page{[this](const std::string& text) {
                if (page_) page_->tell(text);
            }};
            const EndsRuns ends{[&] { return written(course_, all_) != seen_; }};
            try {
                tracer(course_, {});
            } catch (const std::exception& error) {
                print(std::string{"course: "} + error.what() + '\n');
            }
        }
        if (page_) page_->end_tracer();
        go_on(true);
    }

    // In the terminal and on the page.
    void say(const std::string& text) {
        print(text);
        if (page_) page_->tell(text);
    }
    void tell_next(const std::string& words, bool is_said = false,
                   const std::optional<Chapter>& graft = {}) {
        if (!is_said) print('\n' + words);
        if (page_) page_->show_next(words, all_[current_], graft);
        print_keys();
    }

    std::optional<char> next_key() {
        if (key_) return std::exchange(key_, std::nullopt);
        return keyboard_.key(pause_ms);
    }

    // Until a file is saved, a key is pressed, or something is asked on the page.
    void work_for_page() {
        std::mutex asking;  // programs run in several threads
        const std::function<bool()> is_over = [&] {
            const std::lock_guard lock{asking};
            if (!key_) key_ = keyboard_.key(0);
            return key_ || keyboard_.at_end() || page_->is_asked() ||
                   written(course_, all_) != seen_;
        };
        page_->work(is_over);
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
        if (page_) page_->renew();
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
        tell_next(next_step(course_, all_[current_]));
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
                  all_[current_].id + ": save a file to check it)\n" +
                  (page_ ? "Your work in the browser: " + page_->address() + '\n' : "")));
    }

    int end_of_input() const {
        return first_open(course_, read_state(course_), all_) ? app::still_to_write : app::done;
    }

    const Course& course_;
    std::vector<Exercise> all_;
    std::size_t current_;
    LivePage* page_;  // null: the terminal alone
    bool on_terminal_;
    Keyboard keyboard_;
    std::optional<char> key_;  // pressed while something was drawn
    Written seen_;
    bool tracer_has_changed_ = false;
    std::thread preparing_;
};

// The page, if it is wanted: on a terminal of this machine, where there is a browser, or if it is
// asked for.
std::unique_ptr<LivePage> open_page(const Course& course, const Given& given) {
    const bool is_asked = given.has("--page");
    const char* const over_ssh = std::getenv("SSH_CONNECTION");
    if (given.has("--no-page") || !(is_asked || (app::is_terminal(stdout) && !over_ssh))) return {};
    if (Server::is_possible()) return std::make_unique<LivePage>(course);
    const std::string how =
        "install cpp-httplib (Debian: libcpp-httplib-dev), then type\n"
        "  cmake --preset release && cmake --build build --target course\n";
    if (is_asked) throw app::Failure("to show the page, " + how);
    const fs::path told = private_folder(course) / "told-of-page";
    if (fs::exists(told)) return {};
    print(dim("watch can also show your picture in the browser at each save: " + how));
    app::replace_file(told, "");
    return {};
}

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
    const std::unique_ptr<LivePage> page = open_page(course, given);
    return Watch{course, std::move(all), first, page.get()}.run();
}

}  // namespace companion
