#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <app/signals.hpp>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <companion/system/process.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <system_error>

namespace companion {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

// The process groups that run now; 0 is none.
struct Running {
    std::atomic<pid_t> group = 0;
    std::atomic<bool> passes_signals = false;
};
Running running[16];
std::atomic<int> passed_on = 0;

// True if a group is left to end by itself.
bool end_running_groups(int signal) {
    bool passed = false;
    for (const Running& one : running) {
        const pid_t id = one.group;
        if (id == 0) continue;
        const bool passes = one.passes_signals && (signal == SIGINT || signal == SIGTERM);
        ::kill(-id, passes ? signal : SIGKILL);
        passed = passed || passes;
    }
    if (passed) passed_on = signal;
    return passed;
}

// While one of these exists, a signal that interrupts the companion also ends the group, or is
// passed on to it. It works for sixteen groups at a time; one more would live on.
class EndedOnInterrupt {
  public:
    EndedOnInterrupt(pid_t id, bool passes_signals) {
        static const app::OnSignal on_signal{app::ending_signals, end_running_groups};
        for (Running& one : running) {
            pid_t none = 0;
            if (!one.group.compare_exchange_strong(none, id)) continue;
            one.passes_signals = passes_signals;
            one_ = &one;
            return;
        }
    }
    ~EndedOnInterrupt() {
        if (!one_) return;
        one_->passes_signals = false;
        one_->group = 0;
    }
    EndedOnInterrupt(const EndedOnInterrupt&) = delete;
    EndedOnInterrupt& operator=(const EndedOnInterrupt&) = delete;

  private:
    Running* one_ = nullptr;
};

// Between fork and exec, only system calls are allowed.
[[noreturn]] void become(char* const* command, const char* folder, int out, int err,
                         std::size_t most_memory) {
    ::setpgid(0, 0);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
    if (out >= 0) ::dup2(out, STDOUT_FILENO);
    if (err >= 0) ::dup2(err, STDERR_FILENO);
    if (most_memory > 0) {
        const rlimit limit{most_memory, most_memory};
        ::setrlimit(RLIMIT_DATA, &limit);
    }
    if (::chdir(folder) == 0) ::execvp(command[0], command);
    ::_exit(127);
}

// A running program, and the end of the pipe from which its output is read.
class Child {
  public:
    Child(pid_t id, int pipe) : id_{id}, pipe_{pipe}, start_{Clock::now()} {}

    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    // Waits until it ends, the time is over or its output is too much, and collects its output.
    Result wait(double timeout, std::size_t most_output) {
        Result result;
        int status = 0;
        for (int pause = 1; !has_ended(status); pause = std::min(2 * pause, 20)) {
            result.timed_out = timeout > 0 && seconds() > timeout;
            result.too_much = most_output > 0 && result.output.size() > most_output;
            if (result.timed_out && end_politely(status, result.output)) break;
            if (result.timed_out || result.too_much) {
                ::kill(-id_, SIGKILL);
                while (::wait4(id_, &status, 0, &used_) < 0 && errno == EINTR) {
                }
                break;
            }
            if (read_for(pause, result.output)) pause = 1;
        }
        result.seconds = seconds();
        for (const timeval& time : {used_.ru_utime, used_.ru_stime})
            result.cpu_seconds +=
                static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        while (read_for(0, result.output)) {
        }  // what was still in the pipe
        if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
        if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
        return result;
    }

  private:
    bool has_ended(int& status) {
        const pid_t ended = ::wait4(id_, &status, WNOHANG, &used_);
        if (ended < 0 && errno != EINTR) fail("wait4");
        return ended == id_;
    }

    // Asks it to end, so that it can say what it was doing. False if it has not
    // ended after half a second.
    bool end_politely(int& status, std::string& output) {
        ::kill(-id_, SIGTERM);
        for (const auto start = Clock::now();
             Clock::now() - start < std::chrono::milliseconds(500);) {
            if (has_ended(status)) return true;
            read_for(10, output);
        }
        return false;
    }

    // Waits for output, for at most this many milliseconds. True if there was some.
    bool read_for(int milliseconds, std::string& output) {
        pollfd from{pipe_, POLLIN, 0};  // poll skips a pipe of -1 and only waits
        if (::poll(&from, 1, milliseconds) <= 0) return false;
        char bytes[65536];
        const ssize_t count = ::read(pipe_, bytes, sizeof bytes);
        if (count > 0) output.append(bytes, static_cast<std::size_t>(count));
        if (count == 0) pipe_ = -1;  // its other end is closed: nothing more will come
        return count > 0;
    }

    pid_t id_;
    int pipe_;
    Clock::time_point start_;
    rusage used_{};
};

// Closes what it holds.
struct Descriptor {
    int value = -1;
    Descriptor() = default;
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }
    void close() {
        if (value >= 0) ::close(value);
        value = -1;
    }
};

}  // namespace

Result run_process(const Run& run) {
    Descriptor from, into;
    if (run.output != Output::shown) {
        int ends[2];
        if (::pipe(ends) != 0) fail("pipe");
        from.value = ends[0];
        into.value = ends[1];
        for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    std::vector<std::string> words = run.command;
    std::vector<char*> command;
    for (std::string& word : words) command.push_back(word.data());
    command.push_back(nullptr);
    Descriptor nowhere;
    if (run.output == Output::errors_hidden)
        nowhere.value = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    const int err = run.output == Output::captured ? into.value : nowhere.value;

    std::fflush(nullptr);  // otherwise parts of the output would swap positions
    const pid_t id = ::fork();
    if (id < 0) fail("fork");
    if (id == 0) become(command.data(), run.folder.c_str(), into.value, err, run.most_memory);
    ::setpgid(id, id);  // in both processes, since either may come first
    if (run.passes_signals) passed_on = 0;
    const EndedOnInterrupt guard{id, run.passes_signals};
    into.close();
    Result result = Child{id, from.value}.wait(run.timeout, run.most_output);
    if (run.passes_signals) result.passed_on = passed_on;
    return result;
}

std::string how_it_ended(const Result& result) {
    std::ostringstream text;
    if (result.timed_out)
        text << "it timed out after " << static_cast<int>(result.seconds) << " s";
    else if (result.too_much)
        text << "it printed more than " << (result.output.size() >> 20) << " MB";
    else if (result.signal)
        text << "signal " << result.signal << " (" << ::strsignal(result.signal) << ')';
    else if (result.exit_code == 127)
        text << "it could not be started";
    else
        text << "exit code " << result.exit_code;
    return text.str();
}

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders{path ? path : ""};
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((folder + '/' + program).c_str(), X_OK) == 0) return true;
    return false;
}

}  // namespace companion
