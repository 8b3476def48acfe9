#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <companion/system/background.hpp>
#include <csignal>
#include <cstdio>

namespace companion {
namespace {

// What this process inherited ends here: the terminal, open files and the locks on them, and what
// it did at a signal.
void leave_parent(int terminal) {
    ::setsid();
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP})
        std::signal(signal, SIG_DFL);
    for (int i = 0; i < 1024; ++i)
        if (i != terminal) ::close(i);
    for (int i = 0; i < 3; ++i)
        if (::open("/dev/null", O_RDWR) < 0) ::_exit(1);
    constexpr int low = 10;
    ::setpriority(PRIO_PROCESS, 0, low);
}

}  // namespace

bool in_background(const std::function<void(const std::function<bool()>&)>& work) {
    std::fflush(nullptr);
    const pid_t first = ::fork();
    if (first > 0)  // it ends at once, so that the process is nobody's child
        while (::waitpid(first, nullptr, 0) < 0 && errno == EINTR) {
        }
    if (first != 0) return first > 0;
    const int terminal = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (terminal < 0 || ::fork() != 0) ::_exit(0);
    leave_parent(terminal);
    try {
        work([terminal] {
            pollfd closed{terminal, 0, 0};
            return ::poll(&closed, 1, 0) > 0;
        });
    } catch (...) {
        // Nobody reads here what went wrong. The next check meets it again, and says so.
    }
    ::_exit(0);
}

}  // namespace companion
