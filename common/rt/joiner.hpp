#pragma once
#include <thread>
#include <vector>

namespace rt {

// Waits for threads at the end of its own scope, however that is left: also by an exception. A
// std::thread that nobody has waited for ends the whole program when it is destroyed. Make the
// vector first and the joiner second, for scopes are cleared from their last variable on.
// std::jthread of C++20 joins itself; not every standard library has it yet.
class Joiner {
  public:
    explicit Joiner(std::vector<std::thread>& threads) : threads_{threads} {}
    ~Joiner() {
        for (std::thread& thread : threads_)
            if (thread.joinable()) thread.join();
    }
    Joiner(const Joiner&) = delete;
    Joiner& operator=(const Joiner&) = delete;

  private:
    std::vector<std::thread>& threads_;
};

}  // namespace rt
