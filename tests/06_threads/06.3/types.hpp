#pragma once
// A type that both sides know.

#include <atomic>
#include <rt/rng.hpp>
#include <utility>
#include <vector>

namespace answer {

// A counter that counts as std::atomic<int> does, but after every step another worker takes a tile
// at once. What two threads do to each other once in a million times happens here every time.
class HauntedCounter {
  public:
    using value_type = int;
    using Order = std::memory_order;

    // The other worker comes after every step, or after half of the steps, picked at random. After
    // every step but an exchange that failed, because a loop that tries again would never end.
    explicit HauntedCounter(unsigned seed) : always{seed == 0}, guests{seed, 6} {}

    int fetch_add(int n, Order = {}) {
        return step([&] { return std::exchange(value_, value_ + n); });
    }
    int fetch_sub(int n, Order = {}) { return fetch_add(-n); }
    int operator++(int) { return fetch_add(1); }
    int operator++() { return fetch_add(1) + 1; }
    int operator--(int) { return fetch_add(-1); }
    int operator--() { return fetch_add(-1) - 1; }
    int operator+=(int n) { return fetch_add(n) + n; }
    int operator-=(int n) { return fetch_add(-n) - n; }
    int load(Order = {}) const {
        return step([&] { return value_; });
    }
    operator int() const { return load(); }
    void store(int n, Order = {}) {
        step([&] { return value_ = n; });
    }
    int operator=(int n) {
        store(n);
        return n;
    }
    int exchange(int n, Order = {}) {
        return step([&] { return std::exchange(value_, n); });
    }
    bool compare_exchange_strong(int& expected, int desired, Order = {}, Order = {}) {
        const bool same = value_ == expected;
        expected = step([&] { return same ? std::exchange(value_, desired) : value_; }, same);
        return same;
    }
    bool compare_exchange_weak(int& expected, int desired, Order = {}, Order = {}) {
        return compare_exchange_strong(expected, desired);
    }

    // The number itself, for the test alone: looking at it does not count as a step.
    int now() const { return value_; }

    // Which tiles the other worker took.
    mutable std::vector<int> taken;

  private:
    template <class Step>
    int step(Step work, bool succeeds = true) const {
        const int result = work();
        if (always ? succeeds : guests() % 2 == 0) taken.push_back(value_++);
        return result;
    }

    bool always;
    mutable rt::Rng guests;
    mutable int value_ = 0;
};

}  // namespace answer
