#pragma once
#include <thread>
#include <vector>

namespace rt {

// Joins threads at the end of its own scope, however the scope is left, even by an exception. A
// std::thread that is destroyed before it is joined ends the whole program. Declare the vector
// first and the guard second, because locals are destroyed in reverse order. std::jthread of C++20
// joins by itself, but not every standard library has it yet.
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
