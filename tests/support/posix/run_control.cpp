#include "run_control.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

extern char** environ;

namespace checkpoint {
namespace {

char word[64];

// Calls nothing of the C library, which is not ready where the system is Linux.
void take_secret(char** environment) {
    for (; environment && *environment; ++environment) {
        const char* name = "COURSE_EVENTS=";
        char* at = *environment;
        while (*name && *at == *name) ++at, ++name;
        if (*name) continue;
        std::size_t length = 0;
        for (; *at && length + 1 < sizeof word; ++at) {
            word[length++] = *at;
            *at = '-';
        }
    }
}

#if defined(__GLIBC__) && !defined(RT_SANITIZED)
// Before any code of a library, and so before the answer's.
[[gnu::used, gnu::section(".preinit_array")]] void (*const before_libraries)(int, char**, char**) =
    [](int, char**, char** environment) { take_secret(environment); };
#else
const bool is_taken = (take_secret(environ), true);
#endif

struct Crash {
    int signal;
    const char* name;
};
constexpr Crash crashes[]{
    {SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"},  {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"},
    {SIGABRT, "SIGABRT"}, {SIGTERM, "SIGTERM"}};  // the companion's at a time-out
std::uintptr_t stack_end = 0;
Tell tell_crash = nullptr;

void report(int signal, siginfo_t* info, void*) {
    constexpr std::uintptr_t page = 4096, near = 1 << 20;
    const char* memory = "";
    const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
    if ((signal == SIGSEGV || signal == SIGBUS) && info->si_code > 0) {
        if (address < page) memory = "null";
        if (stack_end > 0 && address + near > stack_end && address < stack_end + near)
            memory = "stack";
    }
    for (const Crash& crash : crashes)
        if (crash.signal == signal) tell_crash(crash.name, memory);
    std::raise(signal);
}

constexpr int looks_a_second = 4;
const volatile std::sig_atomic_t* watched = nullptr;
Stuck stuck;

// Counts looks in a row that find the program stuck at the same step.
struct Looks {
    std::sig_atomic_t seen = 0;
    int stuck_looks = 0;

    void count(bool is_stuck, const char* event) {
        stuck_looks = is_stuck && *watched == seen ? stuck_looks + 1 : 0;
        seen = *watched;
        // The first look may come right after the last step.
        if (stuck_looks <= stuck.seconds * looks_a_second) return;
        write_line(stuck.file, event, std::strlen(event));
        std::signal(SIGPROF, SIG_IGN);
        // The rest allocates memory. If the tested code was doing that, it never ends, either.
        std::signal(SIGALRM, SIG_DFL);
        ::alarm(1);
        std::raise(SIGTERM);  // which is told with the hints of the test case
    }
};
Looks at_processor_time, at_time;

void look_after_computing(int) {
    at_processor_time.count(true, stuck.computes);
}

bool has_children() {
    siginfo_t info{};
    return ::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) == 0;
}

void look_after_time(int) {
    static std::clock_t before = 0;
    static long switches_before = 0;
    const int error = errno;
    const std::clock_t now = std::clock();
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    // A thread that looks a hundred times a second whether it may go on computes for 1 % of the
    // time. So may a loop on a busy machine, but the system takes the processor away from it.
    const bool is_idle = now - before < CLOCKS_PER_SEC / looks_a_second / 20 &&
                         used.ru_nivcsw == switches_before && !has_children();
    before = now;
    switches_before = used.ru_nivcsw;
    at_time.count(is_idle, stuck.waits);
    errno = error;
}

void look_often(int timer, int signal, void (*look)(int)) {
    struct sigaction action {};
    action.sa_handler = look;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
    const itimerval often{{0, 1'000'000 / looks_a_second}, {0, 1'000'000 / looks_a_second}};
    setitimer(timer, &often, nullptr);
}

pid_t process = 0;
void (*last_call)() = nullptr;

}  // namespace

const char* secret_word() {
    return word;
}

void tell_crashes(Tell tell, bool catch_tells_signals) {
    if (catch_tells_signals) return;
    tell_crash = tell;
    static char stack[1 << 16];  // since a full stack leaves no room
    stack_t own{};
    own.ss_sp = stack;
    own.ss_size = sizeof stack;
    sigaltstack(&own, nullptr);
    for (const Crash& crash : crashes) {
        struct sigaction action {};
        action.sa_sigaction = report;
        action.sa_flags = SA_ONSTACK | SA_SIGINFO | SA_RESETHAND | SA_NODEFER;
        sigaction(crash.signal, &action, nullptr);
    }
    rlimit limit{};
    getrlimit(RLIMIT_STACK, &limit);
    char here = 0;
    if (limit.rlim_cur != RLIM_INFINITY)
        stack_end = reinterpret_cast<std::uintptr_t>(&here) - limit.rlim_cur;
}

void end_when_stuck(const volatile std::sig_atomic_t& step, const Stuck& when) {
    watched = &step;
    stuck = when;
    look_often(ITIMER_PROF, SIGPROF, look_after_computing);
    look_often(ITIMER_REAL, SIGALRM, look_after_time);
}

void at_exit(void (*call)()) {
    process = ::getpid();
    last_call = call;
    std::atexit([] {
        if (::getpid() == process) last_call();
    });
}

int end_program(int code) {
    return code;
}

}  // namespace checkpoint
