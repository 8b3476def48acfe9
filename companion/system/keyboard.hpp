#pragma once
#include <app/signals.hpp>
#include <optional>

namespace companion {

// Single keys from the standard input. On a terminal they arrive without Enter and are not
// shown, as long as this object exists; however the program ends, even by a signal, the terminal
// is then as it was before.
class Keyboard {
  public:
    // immediately: keys arrive without Enter, if the standard input is a terminal.
    explicit Keyboard(bool immediately);
    ~Keyboard();
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    // The next key, after waiting for at most this long. None if there was none.
    std::optional<char> key(int milliseconds);

    // No more keys will come.
    bool at_end() const { return at_end_; }

  private:
    bool at_end_ = false;
    std::optional<app::OnSignal> on_signal_;  // if the terminal was changed
};

}  // namespace companion
