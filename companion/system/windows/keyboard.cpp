#include <windows.h>

#include <chrono>
#include <companion/system/keyboard.hpp>
#include <thread>

namespace companion {
namespace {

// The console's settings before reading. The signal handler uses them, so they are set before the
// handler is.
DWORD before = 0;

bool restore_console(int) {
    ::SetConsoleMode(::GetStdHandle(STD_INPUT_HANDLE), before);
    return false;
}

using Clock = std::chrono::steady_clock;

// The key of the console's next event; none if the event is not a key.
std::optional<char> key_of_event(HANDLE console) {
    INPUT_RECORD event{};
    DWORD count = 0;
    if (!::ReadConsoleInputW(console, &event, 1, &count) || count == 0) return std::nullopt;
    const wchar_t key = event.Event.KeyEvent.uChar.UnicodeChar;
    if (event.EventType != KEY_EVENT || !event.Event.KeyEvent.bKeyDown || key == 0 || key > 127)
        return std::nullopt;
    return static_cast<char>(key);
}

}  // namespace

Keyboard::Keyboard(bool immediately) {
    const HANDLE in = ::GetStdHandle(STD_INPUT_HANDLE);
    if (!immediately || !::GetConsoleMode(in, &before)) return;
    on_signal_.emplace(app::ending_signals, restore_console);
    ::SetConsoleMode(in, (before | ENABLE_PROCESSED_INPUT) &
                             ~static_cast<DWORD>(ENABLE_LINE_INPUT | ENABLE_ECHO_INPUT));
}

Keyboard::~Keyboard() {
    if (on_signal_) restore_console(0);
}

std::optional<char> Keyboard::key(int milliseconds) {
    const HANDLE in = ::GetStdHandle(STD_INPUT_HANDLE);
    const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
    DWORD mode = 0;
    while (!at_end_) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left < 0) return std::nullopt;
        if (::GetConsoleMode(in, &mode)) {
            if (::WaitForSingleObject(in, static_cast<DWORD>(left)) != WAIT_OBJECT_0)
                return std::nullopt;
            if (const auto key = key_of_event(in)) return key;
            continue;
        }
        // A program cannot wait for input from a pipe here, so it looks often.
        DWORD waiting = 0;
        if (::GetFileType(in) == FILE_TYPE_PIPE) {
            const bool is_known = ::PeekNamedPipe(in, nullptr, 0, nullptr, &waiting, nullptr);
            // Wine cannot look into a pipe that was made by a Linux program: no keys come from such
            // a pipe.
            if (!is_known && ::GetLastError() != ERROR_NOT_SUPPORTED) {
                at_end_ = true;
            } else if (waiting == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
                continue;
            }
        }
        char key = 0;
        DWORD count = 0;
        if (!at_end_ && ::ReadFile(in, &key, 1, &count, nullptr) && count == 1) return key;
        at_end_ = true;
    }
    std::this_thread::sleep_until(end);
    return std::nullopt;
}

}  // namespace companion
