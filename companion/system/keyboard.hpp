#pragma once
#include <app/signals.hpp>
#include <optional>

namespace companion {

// Single keys from the standard input. On a terminal, while this object exists, they arrive without
// Enter and are not shown. However the program ends, even by a signal, the terminal is then as it
// was before.
class Keyboard {
  public:
    // If `immediately` is true and the standard input is a terminal, keys arrive without Enter.
    explicit Keyboard(bool immediately);
    ~Keyboard();
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    // The next key, or none if no key comes within this many milliseconds.
    std::optional<char> key(int milliseconds);

    // True if no more keys can come.
    bool at_end() const { return at_end_; }

  private:
    bool at_end_ = false;
    std::optional<app::OnSignal> on_signal_;  // set if the terminal was changed
};

}  // namespace companion
