#pragma once
#include <thread>
#include <vector>

namespace rt {

// Waits for threads at the end of its own scope, however that is left: also by an exception. A
// std::thread that nobody has waited for ends the whole program when it is destroyed. Make the
// vector first and the guard second, for scopes are cleared from their last variable on.
// std::jthread of C++20 joins itself; not every standard library has it yet.
class JoinGuard {
  public:
    explicit JoinGuard(std::vector<std::thread>& threads) : threads_{threads} {}
    ~JoinGuard() {
        for (std::thread& thread : threads_)
            if (thread.joinable()) thread.join();
    }
    JoinGuard(const JoinGuard&) = delete;
    JoinGuard& operator=(const JoinGuard&) = delete;

  private:
    std::vector<std::thread>& threads_;
};

}  // namespace rt
