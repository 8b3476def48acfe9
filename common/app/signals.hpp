#pragma once
// What a program still does when a signal, such as that of Ctrl-C, is about to end it.

#include <csignal>
#include <initializer_list>
#include <vector>

namespace app {

// The signals with which a person or the system ends a program; they differ between systems.
extern const std::initializer_list<int> ending_signals;

// While an OnSignal exists, each of its signals first calls its action, and then ends the program
// as usual. Several may exist at once: all actions are called, the oldest first. A signal that is
// ignored (nohup) or has another handler stays as it is.
class OnSignal {
  public:
    // Returns true if the program should go on; then no other action is called. An action may do
    // only what is allowed in a signal handler.
    using Action = bool (*)(int signal);

    OnSignal(std::initializer_list<int> signals, Action action);
    ~OnSignal();
    OnSignal(const OnSignal&) = delete;
    OnSignal& operator=(const OnSignal&) = delete;

  private:
    std::vector<int> signals_;
    Action action_;
};

}  // namespace app
