#include <algorithm>
#include <atomic>
#include <companion/system/process.hpp>
#include <csignal>
#include <sstream>
#include <utility>

namespace companion {

namespace {
std::function<bool()> runs_are_over;
std::atomic<bool> runs_aside = false;
}  // namespace

EndsRuns::EndsRuns(std::function<bool()> is_over)
    : before_{std::exchange(runs_are_over, std::move(is_over))} {}
EndsRuns::~EndsRuns() {
    runs_are_over = std::move(before_);
}
bool EndsRuns::exists() {
    return runs_are_over != nullptr;
}
bool EndsRuns::is_over() {
    return exists() && runs_are_over();
}

RunsAside::RunsAside() : before_{runs_aside.exchange(true)} {}
RunsAside::~RunsAside() {
    runs_aside = before_;
}
bool RunsAside::exists() {
    return runs_aside;
}

std::size_t memory_of_compiler() {
    constexpr std::size_t gigabyte = std::size_t{1} << 30;
    const std::size_t all = memory_of_machine();
    return all == 0 ? 4 * gigabyte : std::clamp(all / 2, gigabyte, 4 * gigabyte);
}

Crash crash_of(int signal) {
    switch (signal) {
        case 0:
            return Crash::none;
        case SIGSEGV:
#ifdef SIGBUS
        case SIGBUS:
#endif
            return Crash::memory;
        case SIGFPE:
            return Crash::division;
        case SIGABRT:
            return Crash::aborted;
        case SIGILL:
            return Crash::invalid_code;
        default:
            return Crash::other;
    }
}

std::string how_it_ended(const Result& result) {
    std::ostringstream text;
    if (result.timed_out)
        text << "it timed out after " << static_cast<int>(result.seconds) << " s";
    else if (result.too_much)
        text << "it printed more than " << ((result.output.size() + result.events.size()) >> 20)
             << " MB";
    else if (result.started_other)
        text << "it was stopped because it started another process";
    else if (result.signal)
        text << "signal " << result.signal << " (" << name_of_signal(result.signal) << ')';
    else if (result.exit_code == 127)
        text << "it could not be started"
             << (result.why_not_started.empty() ? "" : ": " + result.why_not_started);
    else
        text << "exit code " << result.exit_code;
    return text.str();
}

}  // namespace companion
