#pragma once
// Runs code that may end the program, so that the checkpoint survives it.

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <string>

namespace checkpoint {

// Runs work() in a process of its own, with the usual 8 MiB of stack or less and for at most this
// many seconds, and returns its text; "the program ended" if that process did not survive.
template <class Work>
std::string in_own_process(Work work, unsigned seconds = 20, rlim_t stack = rlim_t{8} << 20) {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    const pid_t child = fork();
    if (child == 0) {
        rlimit limit{};
        getrlimit(RLIMIT_STACK, &limit);
        limit.rlim_cur = std::min(limit.rlim_max, stack);
        setrlimit(RLIMIT_STACK, &limit);
        std::set_terminate([] { _exit(3); });  // what an exception in a thread leads to
        for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGILL}) signal(number, SIG_DFL);
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
    for (ssize_t count; (count = read(ends[0], buffer, sizeof buffer)) > 0;)
        result.append(buffer, static_cast<std::size_t>(count));
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return result.empty() ? "the program ended" : result;
}

}  // namespace checkpoint
