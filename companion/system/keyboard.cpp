#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <companion/system/keyboard.hpp>
#include <companion/system/process.hpp>
#include <csignal>

namespace companion {
namespace {

// For the handlers of signals. They are set before the handlers are.
termios before, while_reading;

constexpr int ending_signals[]{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV};

extern "C" void restore_and_end(int signal) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    end_running();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

// Ctrl-Z, and fg some time later.
extern "C" void restore_and_stop(int) {
    const int error = errno;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    std::raise(SIGSTOP);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &while_reading);
    errno = error;
}

void set_handlers(void (*ending)(int), void (*stopping)(int)) {
    for (const int signal : ending_signals) std::signal(signal, ending);
    std::signal(SIGTSTP, stopping);
}

}  // namespace

Keyboard::Keyboard(bool immediately) {
    if (!immediately || ::tcgetattr(STDIN_FILENO, &before) != 0) return;
    while_reading = before;
    while_reading.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    while_reading.c_cc[VMIN] = 1;
    while_reading.c_cc[VTIME] = 0;
    set_handlers(restore_and_end, restore_and_stop);
    changed_ = ::tcsetattr(STDIN_FILENO, TCSANOW, &while_reading) == 0;
}

Keyboard::~Keyboard() {
    if (!changed_) return;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
    set_handlers(SIG_DFL, SIG_DFL);
}

std::optional<char> Keyboard::key(int milliseconds) {
    pollfd from{STDIN_FILENO, POLLIN, 0};
    if (at_end_ || ::poll(&from, 1, milliseconds) <= 0) return std::nullopt;
    char key = 0;
    const ssize_t count = ::read(STDIN_FILENO, &key, 1);
    if (count == 1) return key;
    // An error such as that of a terminal that is gone does not go away either.
    if (count == 0 || errno != EINTR) at_end_ = true;
    return std::nullopt;
}

}  // namespace companion
