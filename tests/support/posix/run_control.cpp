#include "run_control.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>

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
std::sig_atomic_t seen = 0;
const char* stuck_event = "";
int stuck_file = 0, most_looks = 0, idle_looks = 0;

void look(int) {
    idle_looks = *watched == seen ? idle_looks + 1 : 0;
    seen = *watched;
    // The first look may come right after the last step.
    if (idle_looks <= most_looks) return;
    write_line(stuck_file, stuck_event, std::strlen(stuck_event));
    std::signal(SIGPROF, SIG_IGN);
    // The rest allocates memory. If the tested code was doing that, it never ends, either.
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(1);
    std::raise(SIGTERM);  // which is told with the hints of the test case
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

void end_when_stuck(const volatile std::sig_atomic_t& step, int seconds, const char* event,
                    int file) {
    watched = &step;
    most_looks = seconds * looks_a_second;
    stuck_event = event;
    stuck_file = file;
    struct sigaction action {};
    action.sa_handler = look;
    action.sa_flags = SA_RESTART;
    sigaction(SIGPROF, &action, nullptr);
    const itimerval often{{0, 1'000'000 / looks_a_second}, {0, 1'000'000 / looks_a_second}};
    setitimer(ITIMER_PROF, &often, nullptr);
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
