#include "own_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>

#include "processor_time.hpp"

namespace checkpoint {
namespace {

double seconds_of(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The letter by which Linux says what the first thread of a process does, such as R: it computes,
// or it would if a processor were free. 0 if that is not known.
char state_of(pid_t process) {
    char text[128] = {};
    const std::string name = "/proc/" + std::to_string(process) + "/stat";
    if (std::FILE* const file = std::fopen(name.c_str(), "r")) {
        if (std::fread(text, 1, sizeof text - 1, file) == 0) text[0] = 0;
        std::fclose(file);
    }
    // The number, the program's name in parentheses, the letter.
    const char* const end = std::strrchr(text, ')');
    return end && end[1] == ' ' ? end[2] : '\0';
}

// Notices that a process has computed next to nothing for 3 seconds, although it could have: on a
// machine that has too much to do, it may wait as long for a processor (R) or for a disk (D).
class Idleness {
  public:
    explicit Idleness(pid_t process) : process_{process} {
#ifdef __linux__  // elsewhere, nobody can read the clock of another process
        has_clock_ = clock_getcpuclockid(process, &clock_) == 0;
#endif
    }
    // To be called often. A pause of the whole machine counts as one look.
    bool lasts() {
        const double now = seconds_of(CLOCK_MONOTONIC);
        if (!has_clock_ || now - looked_ < 0.2) return false;
        const double computed = seconds_of(clock_);
        const char state = state_of(process_);
        const bool idle = computed - computed_ < 0.01 && state != 'R' && state != 'D';
        idle_looks_ = idle ? idle_looks_ + 1 : 0;
        looked_ = now;
        computed_ = computed;
        return idle_looks_ > 12;
    }

  private:
    pid_t process_;
    clockid_t clock_{};
    bool has_clock_ = false;
    int idle_looks_ = 0;
    double looked_ = seconds_of(CLOCK_MONOTONIC), computed_ = 0;
};

}  // namespace

std::string in_own_process(const std::function<std::string()>& work, unsigned seconds,
                           std::size_t stack) {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    const pid_t child = fork();
    if (child == 0) {
        rlimit limit{};
        getrlimit(RLIMIT_STACK, &limit);
        limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(stack));
        setrlimit(RLIMIT_STACK, &limit);
        std::set_terminate([] { _exit(3); });  // what an exception in a thread leads to
        for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGALRM})
            signal(number, SIG_DFL);
        alarm(seconds);
        std::string result = "an exception";
        try {
            result = work();
        } catch (...) {
        }
        _exit(write(ends[1], result.data(), result.size()) < 0);
    }
    close(ends[1]);
    std::string result;
    char buffer[256];
    Idleness idleness{child};
    for (bool open = true; open;) {
        pollfd from{ends[0], POLLIN, 0};
        if (poll(&from, 1, 250) > 0) {
            const ssize_t count = read(ends[0], buffer, sizeof buffer);
            open = count > 0;
            if (open) result.append(buffer, static_cast<std::size_t>(count));
        } else if (idleness.lasts()) {
            kill(child, SIGKILL);
            result = "nothing: it waits for something that never comes";
            open = false;
        }
    }
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return result.empty() ? "the program ended" : result;
}

bool leave_room_for_few_threads() {
    long pages = 0;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    const long long used = static_cast<long long>(pages) * sysconf(_SC_PAGESIZE);
    if (used == 0 || used > 1LL << 40) return false;
    const auto limit = static_cast<rlim_t>(used + (64LL << 20));
    rlimit both{limit, limit};
    if (setrlimit(RLIMIT_AS, &both) != 0) return false;
    // Under an emulator of another processor the limit is not set, and nothing says so.
    return getrlimit(RLIMIT_AS, &both) == 0 && both.rlim_cur == limit;
}

Printed run_program(const std::string& program) {
    constexpr unsigned seconds = 10, computing = 3;
    constexpr std::size_t most = std::size_t{64} << 20;
    int ends[2];
    if (pipe(ends) != 0) return {"", "there was no pipe to read its output from"};
    const pid_t child = fork();
    if (child == 0) {
        const int nothing = open("/dev/null", O_RDWR);
        dup2(nothing, STDIN_FILENO);
        dup2(nothing, STDERR_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM, SIGXCPU})
            signal(number, SIG_DFL);
        alarm(seconds);
        const rlimit most_computing{computing, computing + 1};
        setrlimit(RLIMIT_CPU, &most_computing);
        execl(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    Printed printed;
    char buffer[1 << 16];
    for (ssize_t count; (count = read(ends[0], buffer, sizeof buffer)) > 0;) {
        printed.text.append(buffer, static_cast<std::size_t>(count));
        if (printed.text.size() > most) {
            printed.trouble = trouble::too_much;
            kill(child, SIGKILL);
            break;
        }
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!printed.trouble.empty()) return printed;
    if (WIFSIGNALED(status))
        printed.trouble = WTERMSIG(status) == SIGXCPU ? trouble::endless
                          : WTERMSIG(status) == SIGALRM
                              ? trouble::waits
                              : trouble::crashed("signal " + std::to_string(WTERMSIG(status)));
    else if (WEXITSTATUS(status) == 127 && printed.text.empty())
        printed.trouble = trouble::not_started;
    return printed;
}

double processor_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace checkpoint
