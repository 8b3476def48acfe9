#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <companion/system/keyboard.hpp>
#include <csignal>

namespace companion {
namespace {

// The terminal's settings before and while reading. The signal handler uses them, so they are set
// before the handler is.
termios before, while_reading;

// Restores the terminal. Then the signal takes effect: the program ends or, at Ctrl-Z, stops. After
// fg it continues.
bool restore_terminal(int signal) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    if (signal != SIGTSTP) return false;
    std::raise(SIGSTOP);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &while_reading);
    return true;
}

}  // namespace

Keyboard::Keyboard(bool immediately) {
    if (!immediately || ::tcgetattr(STDIN_FILENO, &before) != 0) return;
    while_reading = before;
    while_reading.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    while_reading.c_cc[VMIN] = 1;
    while_reading.c_cc[VTIME] = 0;
    // Ctrl-C and Ctrl-\ must work, even if a script ignored these signals.
    for (const int signal : {SIGINT, SIGQUIT}) std::signal(signal, SIG_DFL);
    on_signal_.emplace(
        std::initializer_list<int>{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGTSTP},
        restore_terminal);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &while_reading);
}

Keyboard::~Keyboard() {
    if (on_signal_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
}

std::optional<char> Keyboard::key(int milliseconds) {
    fd_set from;  // for select: Apple's poll does not know terminals
    FD_ZERO(&from);
    FD_SET(STDIN_FILENO, &from);
    timeval left{milliseconds / 1000, milliseconds % 1000 * 1000};
    if (at_end_ || ::select(STDIN_FILENO + 1, &from, nullptr, nullptr, &left) <= 0)
        return std::nullopt;
    char key = 0;
    const ssize_t count = ::read(STDIN_FILENO, &key, 1);
    if (count == 1) return key;
    // An error, for example because the terminal is gone, would happen again each time.
    if (count == 0 || errno != EINTR) at_end_ = true;
    return std::nullopt;
}

}  // namespace companion
