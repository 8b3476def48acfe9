#pragma once
#include <app/signals.hpp>
#include <optional>

namespace companion {

// Single keys from the standard input. On a terminal they come without Enter and are not shown, as
// long as this lives; however the program ends, by a signal too, the terminal is as it was before.
class Keyboard {
  public:
    // immediately: keys come without Enter, where the standard input is a terminal.
    explicit Keyboard(bool immediately);
    ~Keyboard();
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    // The next key, waited for this long at most. None where none came.
    std::optional<char> key(int milliseconds);

    // Nothing will come any more.
    bool at_end() const { return at_end_; }

  private:
    bool at_end_ = false;
    std::optional<app::OnSignal> on_signal_;  // where the terminal was changed
};

}  // namespace companion
