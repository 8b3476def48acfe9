#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <app/errors.hpp>
#include <cerrno>
#include <companion/system/scratch_folder.hpp>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace companion {

ScratchFolder::ScratchFolder(const std::string& name) {
    std::string made = std::filesystem::temp_directory_path() / (name + "-XXXXXX");
    int ends[2];
    if (!::mkdtemp(made.data()) || ::pipe(ends) != 0)
        throw app::Failure("cannot make a folder in " +
                           std::filesystem::temp_directory_path().string() + ": " +
                           std::strerror(errno));
    path_ = made;
    for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
    sigset_t all, usual;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &usual);
    remover_ = ::fork();
    if (remover_ == 0) {  // only system calls are allowed here
        ::setsid();       // away from the terminal and its Ctrl-C
        for (int i = 0; i < 1024; ++i)
            if (i != ends[0]) ::close(i);
        char nothing = 0;
        while (::read(ends[0], &nothing, 1) < 0 && errno == EINTR) {
        }
        ::pthread_sigmask(SIG_SETMASK, &usual, nullptr);
        ::execlp("rm", "rm", "-rf", "--", made.c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::pthread_sigmask(SIG_SETMASK, &usual, nullptr);
    ::close(ends[0]);
    held_ = ends[1];
}

ScratchFolder::~ScratchFolder() {
    ::close(static_cast<int>(held_));
    while (remover_ > 0 && ::waitpid(static_cast<pid_t>(remover_), nullptr, 0) < 0 &&
           errno == EINTR) {
    }
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);  // needed if no process could be started
}

}  // namespace companion
