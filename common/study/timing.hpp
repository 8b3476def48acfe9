#pragma once
// How long pieces of work take, beside each other and alone.

#include <functional>
#include <limits>
#include <rt/compiler.hpp>
#include <vector>

namespace study {

// Keeps the compiler from leaving out the computation of a value that nobody reads.
template <class T>
void keep(const T& value) {
    RT_KEEP(value);
}

using Work = std::function<void()>;

// The processor's time for this program, in which others that run at the same time count less; or
// the time on the wall, for work that several threads share.
enum class Clock { processor, wall };

struct Turns {
    int rounds = 3;
    // Within a round a work is repeated until it has taken this long.
    double at_least_ms = 0;
    // A work that takes this long is timed in the first round alone.
    double once_from_ms = std::numeric_limits<double>::infinity();
    Clock clock = Clock::processor;
};

// Times the works in turns: each of them in the first round, then each of them in the second, and
// so on, so that whatever else the machine does disturbs all alike. Returns the nanoseconds of one
// call: for each work a time a round.
std::vector<std::vector<double>> rounds_ns(const std::vector<Work>& works, const Turns& turns = {});

// The same, of each work the median of its rounds.
std::vector<double> in_turns_ns(const std::vector<Work>& works, const Turns& turns = {});

// One work alone.
double time_ns(const Work& work, const Turns& turns = {.rounds = 5, .at_least_ms = 1});

}  // namespace study
