#pragma once
#include <rt/rng.hpp>

namespace checkpoint {

// A random generator whose first three numbers are the smallest or the largest that are possible.
class Extreme : public rt::Rng {
  public:
    // Bit 2 is for the first number, bit 0 for the third: whether it is the largest.
    explicit Extreme(unsigned largest) : Rng{56, 7}, largest_{largest} {}

    rt::Real uniform() {
        if (left_ == 0) return Rng::uniform();
        return next() ? 1 - rt::epsilon / 2 : 0;
    }
    rt::Real uniform(rt::Real low, rt::Real high) { return low + (high - low) * uniform(); }
    result_type operator()() {
        if (left_ == 0) return Rng::operator()();
        return next() ? max() : min();
    }

  private:
    bool next() { return (largest_ >> --left_ & 1) != 0; }

    unsigned largest_;
    int left_ = 3;
};

}  // namespace checkpoint
