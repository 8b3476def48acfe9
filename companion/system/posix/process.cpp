#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <app/platform.hpp>
#include <app/signals.hpp>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <companion/system/posix/confined.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>
#include <system_error>

namespace companion {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

// The keepers of the programs to which signals are passed on; 0 marks a free place.
std::atomic<pid_t> passing[4];
std::atomic<int> passed_on = 0;

// Passes a signal on. True if at least one program is left to end by itself. All other programs end
// when the companion does: see Keeper.
bool pass_on_to_programs(int signal) {
    bool passed = false;
    for (const auto& keeper : passing) {
        const pid_t id = keeper;
        if (id == 0 || (signal != SIGINT && signal != SIGTERM)) continue;
        ::kill(id, signal);
        passed = true;
    }
    if (passed) passed_on = signal;
    return passed;
}

// While one of these exists, signals are passed on to the program of this keeper.
class PassesSignals {
  public:
    explicit PassesSignals(pid_t keeper) {
        static const app::OnSignal on_signal{app::ending_signals, pass_on_to_programs};
        for (auto& one : passing) {
            pid_t none = 0;
            if (!one.compare_exchange_strong(none, keeper)) continue;
            one_ = &one;
            return;
        }
    }
    ~PassesSignals() {
        if (one_) *one_ = 0;
    }
    PassesSignals(const PassesSignals&) = delete;
    PassesSignals& operator=(const PassesSignals&) = delete;

  private:
    std::atomic<pid_t>* one_ = nullptr;
};

// A file descriptor, which is closed when this object is destroyed.
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

// What the processes between this one and the program need to know; it is prepared before the fork.
struct Start {
    const Run& run;
    std::vector<char*> command;
    const char* folder;
    int out = -1, err = -1, events = -1;
    bool is_aside = RunsAside::exists();
    sigset_t signals{};  // those that were blocked before
};

void limit(int what, rlim_t most) {
    const rlimit both{most, most + 1};  // reaching the lower limit raises its own signal
    if (most > 0) ::setrlimit(what, &both);
}

// The last step: this process becomes the program. Between fork and exec, only system calls are
// allowed.
[[noreturn]] void become(const Start& start) {
    // The program gets a group and a session of its own: so it can be ended together with its whole
    // group, and cannot open the terminal.
    ::setsid();
    constexpr int aside = 10;
    if (start.is_aside) ::setpriority(PRIO_PROCESS, 0, aside);
#ifdef __linux__
    // Linux may weigh sessions against each other, whatever the priority of their processes.
    if (const int nice = ::getpriority(PRIO_PROCESS, 0); nice > 0)
        if (const int file = ::open("/proc/self/autogroup", O_WRONLY); file >= 0) {
            const char digits[]{static_cast<char>('0' + nice / 10),
                                static_cast<char>('0' + nice % 10)};
            if (::write(file, digits, sizeof digits) < 0) errno = 0;  // it only takes more time
            ::close(file);
        }
#endif
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
    if (start.out >= 0) ::dup2(start.out, STDOUT_FILENO);
    if (start.err >= 0) ::dup2(start.err, STDERR_FILENO);
    if (start.events >= 0) ::dup2(start.events, 3);
    if (start.events == 3) ::fcntl(3, F_SETFD, 0);
    for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_DFL);  // ignored until here
    limit(RLIMIT_CPU, static_cast<rlim_t>(start.run.most_cpu));
    limit(RLIMIT_DATA, start.run.most_memory);
    limit(RLIMIT_FSIZE, start.run.most_file);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends the program if its keeper is killed
#endif
    if (::chdir(start.folder) == 0) {
        if (!start.run.may_start_others) confine_to(start.command[0]);
        ::pthread_sigmask(SIG_SETMASK, &start.signals, nullptr);
        if (start.run.may_start_others)
            ::execvp(start.command[0], start.command.data());
        else
            ::execv(start.command[0], start.command.data());
    }
    ::_exit(127);
}

// A keeper is a process between the companion and a program. Whatever the program starts and leaves
// behind becomes a child of the keeper, in whatever group or session it is, and is ended with the
// program. If the companion ends, even because it was killed, the keeper's end of their socket is
// closed; the keeper then ends everything.
namespace keeper {

pid_t program = 0;

extern "C" void pass_on(int signal) {
    if (signal != SIGCHLD && ::kill(-program, signal) != 0) ::kill(program, signal);
}

// Closes all inherited descriptors except these.
void close_others(int one, int two, int three, int four) {
    rlimit most{};
    ::getrlimit(RLIMIT_NOFILE, &most);
    const int end = static_cast<int>(std::min<rlim_t>(most.rlim_cur, 1024));
    for (int i = 3; i < end; ++i)
        if (i != one && i != two && i != three && i != four) ::close(i);
}

bool has_ended(pid_t id) {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(id), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == id;
}

// Kills all children that the system lists.
void kill_children() {
    char list[4096];
    const int file = ::open("/proc/thread-self/children", O_RDONLY);
    if (file < 0) return;
    const ssize_t size = ::read(file, list, sizeof list - 1);
    ::close(file);
    pid_t id = 0;
    for (ssize_t i = 0; i < size; ++i) {
        if (list[i] != ' ') {
            id = 10 * id + (list[i] - '0');
            continue;
        }
        if (id > 0) ::kill(id, SIGKILL);
        id = 0;
    }
}

// Kills the program and all that it started. Returns the program's wait status.
int end_all() {
    int ended = SIGKILL;
    for (int tries = 0; tries < 2000; ++tries) {
        ::kill(-program, SIGKILL);
        kill_children();
        int status = 0;
        pid_t id = 0;
        while ((id = ::waitpid(-1, &status, WNOHANG)) > 0)
            if (id == program) ended = status;
        if (id < 0 && errno == ECHILD) break;
        ::poll(nullptr, 0, 1);
    }
    return ended;
}

// Starts the program, waits until it or the companion ends, and sends its status to the companion.
[[noreturn]] void keep(const Start& start, int companion) {
    ::setsid();
    close_others(start.out, start.err, start.events, companion);
#ifdef __linux__
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    program = ::fork();
    if (program == 0) become(start);
    if (program < 0) ::_exit(1);
    for (const int descriptor : {start.out, start.err, start.events})
        if (descriptor >= 0) ::close(descriptor);
    struct sigaction action {};
    action.sa_handler = pass_on;
    for (const int signal : {SIGCHLD, SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    while (!has_ended(program)) {
        fd_set from;
        FD_ZERO(&from);
        FD_SET(companion, &from);
        if (::pselect(companion + 1, &from, nullptr, nullptr, nullptr, &none) > 0) break;
    }
    const int status = end_all();
    ::_exit(::write(companion, &status, sizeof status) != sizeof status);
}

}  // namespace keeper

// A running program, known through its keeper, and the pipes from which its output is read.
class Child {
  public:
    Child(pid_t keeper, int socket, int out, int events, bool is_shown)
        : keeper_{keeper}, pipes_{socket, out, events}, is_shown_{is_shown}, start_{Clock::now()} {}

    // Waits until the program ends, the time is over or there is too much output; collects the
    // output.
    Result wait(double timeout, std::size_t most_output) {
        Result result;
        while (!is_over_) {
            const double left = timeout > 0 ? timeout - seconds() : 1;
            result.timed_out = left <= 0;
            const bool ends = result.timed_out || EndsRuns::is_over();
            result.too_much =
                most_output > 0 && result.output.size() + result.events.size() > most_output;
            if (ends) end_politely(result);
            if (ends || result.too_much) {
                ::shutdown(pipes_[0], SHUT_WR);
                // A program that stops its keeper again and again loses it.
                for (const double start = seconds(); !is_over_;) {
                    if (seconds() - start > 5) ::kill(keeper_, SIGKILL);
                    read_for(100, result, most_output);
                }
                break;
            }
            const double until_asked = EndsRuns::exists() ? 100 : 1000;  // milliseconds
            read_for(static_cast<int>(timeout > 0 ? std::min(1000 * left + 1, until_asked)
                                                  : until_asked),
                     result);
        }
        while (read_for(0, result)) {
        }  // reads what is still in the pipes
        if (is_shown_) shown_.end();
        rusage used{};
        while (::wait4(keeper_, nullptr, 0, &used) < 0 && errno == EINTR) {
        }
        result.seconds = seconds();
        for (const timeval& time : {used.ru_utime, used.ru_stime})
            result.cpu_seconds +=
                static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        if (WIFSIGNALED(status_)) result.signal = WTERMSIG(status_);
        if (WIFEXITED(status_)) result.exit_code = WEXITSTATUS(status_);
        return result;
    }

  private:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    // Asks the program to end, so that it can say what it was doing, and waits for its end for half
    // a second.
    void end_politely(Result& result) {
        ::kill(keeper_, SIGTERM);
        for (const auto start = Clock::now();
             !is_over_ && Clock::now() - start < std::chrono::milliseconds(500);)
            read_for(10, result);
    }

    // Waits for output or the end, for at most this many milliseconds. True if there was output.
    // Output beyond `most` bytes is lost; 0 means no limit.
    bool read_for(int milliseconds, Result& result, std::size_t most = 0) {
        pollfd from[3]{};
        for (int i = 0; i < 3; ++i) from[i] = {pipes_[i], POLLIN, 0};  // poll ignores -1
        if (::poll(from, 3, milliseconds) <= 0) {
            ::kill(keeper_, SIGCONT);  // the program may have stopped it
            return false;
        }
        bool some = false;
        std::string* const texts[]{nullptr, &result.output, &result.events};
        for (int i = 1; i < 3; ++i) {
            if (from[i].revents == 0) continue;
            char bytes[65536];
            const ssize_t count = ::read(pipes_[i], bytes, sizeof bytes);
            if (count > 0 && is_shown_)
                shown_.add(bytes, static_cast<std::size_t>(count));
            else if (count > 0 && (most == 0 || texts[i]->size() <= most))
                texts[i]->append(bytes, static_cast<std::size_t>(count));
            if (count == 0) pipes_[i] = -1;  // its other end is closed: nothing more will come
            some = some || count > 0;
        }
        if (from[0].revents != 0 && !is_over_) {
            is_over_ = true;
            // If the keeper itself was killed, it sends no status.
            if (::read(pipes_[0], &status_, sizeof status_) != sizeof status_) status_ = SIGKILL;
            pipes_[0] = -1;
        }
        return some;
    }

    pid_t keeper_;
    int pipes_[3];
    bool is_shown_;  // output is shown, and not kept
    Shown shown_;
    Clock::time_point start_;
    bool is_over_ = false;
    int status_ = 0;
};

void make_pipe(Descriptor& from, Descriptor& into) {
    int ends[2];
    if (::pipe(ends) != 0) fail("pipe");
    from.value = ends[0];
    into.value = ends[1];
    for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
}

}  // namespace

Result run_process(const Run& run) {
    Descriptor from, into, events_from, events_into, nowhere, mine, keepers;
    const bool is_shown = run.output == Output::printable && app::is_terminal(stdout);
    if (is_shown || (run.output != Output::shown && run.output != Output::printable))
        make_pipe(from, into);
    if (run.has_events) make_pipe(events_from, events_into);
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) fail("socketpair");
    mine.value = ends[0];
    keepers.value = ends[1];
    for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
    if (run.output == Output::errors_hidden || run.output == Output::errors_only)
        nowhere.value = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    std::vector<std::string> words = run.command;
    Start start{run, {}, run.folder.c_str(), into.value};
    for (std::string& word : words) start.command.push_back(word.data());
    start.command.push_back(nullptr);
    start.err = run.output == Output::captured ? into.value : nowhere.value;
    if (run.output == Output::errors_only) {
        start.out = nowhere.value;
        start.err = into.value;
    }
    start.events = events_into.value;

    std::fflush(nullptr);  // otherwise buffered output could come too late
    // All signals are blocked, so that the keeper does not run the companion's handlers.
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &start.signals);
    const pid_t keeper = ::fork();
    if (keeper == 0) keeper::keep(start, keepers.value);
    const int error = errno;
    if (run.passes_signals) passed_on = 0;
    std::optional<PassesSignals> passes;
    if (keeper > 0 && run.passes_signals) passes.emplace(keeper);
    ::pthread_sigmask(SIG_SETMASK, &start.signals, nullptr);
    if (keeper < 0) {
        errno = error;
        fail("fork");
    }
    keepers.close();
    into.close();
    events_into.close();
    Result result = Child{keeper, mine.value, from.value, events_from.value, is_shown}.wait(
        run.timeout, run.most_output);
    if (run.passes_signals) result.passed_on = passed_on;
    result.started_other = !run.may_start_others && result.signal == SIGSYS;
    return result;
}

std::size_t memory_of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page <= 0) return 0;
    return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page);
}

std::string name_of_signal(int signal) {
    return ::strsignal(signal);
}

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders{path ? path : ""};
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((folder + '/' + program).c_str(), X_OK) == 0) return true;
    return false;
}

}  // namespace companion
