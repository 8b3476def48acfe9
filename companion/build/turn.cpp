#include <app/files.hpp>
#include <chrono>
#include <companion/build/turn.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/terminal.hpp>
#include <optional>
#include <thread>

namespace companion {
namespace {

fs::path turn_file(const Course& course) {
    return private_folder(course) / "turn.lock";
}

fs::path wanted_file(const Course& course) {
    return private_folder(course) / "turn-wanted.lock";
}

// Takes the lock, and shows on a terminal for what it waits.
FileLock turn(const Course& course) {
    std::optional<WaitingLine> waiting;
    std::optional<FileLock> wanted;
    return FileLock{
        turn_file(course), Hold::shared, [&] {
            wanted.emplace(wanted_file(course), Hold::shared);
            std::error_code none;
            const fs::path file = ahead_file(course);
            const std::string what = fs::exists(file, none) ? read_text(file) : "something";
            waiting.emplace("waiting for " + what + ", which another ./course is building");
            return true;
        }};
}

}  // namespace

Turn::Turn(const Course& course) : lock_{turn(course)} {}

StepAhead::StepAhead(const Course& course, const std::string& what,
                     const std::function<bool()>& is_over)
    : wanted_{wanted_file(course)} {
    for (; !is_over(); lock_.reset()) {
        // Time for those who wait for the turn to take it.
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        lock_.emplace(turn_file(course), Hold::alone, [] { return false; });
        if (!lock_->is_held()) continue;
        if (fs::exists(ahead_file(course))) app::replace_file(ahead_file(course), what);
        return;
    }
}

bool StepAhead::is_wanted() const {
    return !FileLock{wanted_, Hold::alone, [] { return false; }}.is_held();
}

fs::path ahead_file(const Course& course) {
    return course.build / "building-ahead";
}

}  // namespace companion
