#pragma once
// Measures the time of several pieces of work in turns, or of a single one.

#include <functional>
#include <limits>
#include <rt/compiler.hpp>
#include <vector>

namespace study {

// Keeps the compiler from leaving out a computation whose value nobody reads.
template <class T>
void keep(const T& value) {
    RT_KEEP(value);
}

using Work = std::function<void()>;

// Processor time of this program, because other running programs disturb it less; or wall-clock
// time, for work that several threads share.
enum class Clock { processor, wall };

struct Turns {
    int rounds = 5;
    // Within a round, each piece of work is repeated until it has taken this long.
    double at_least_ms = 0;
    // A piece of work that takes this long is timed in the first round only.
    double once_from_ms = std::numeric_limits<double>::infinity();
    Clock clock = Clock::processor;
};

// Times the pieces of work in turns: all of them in the first round, then all of them in the
// second, and so on. So whatever else the machine does disturbs all of them alike. Returns the
// nanoseconds of one call: for each piece of work, one time per round.
std::vector<std::vector<double>> rounds_ns(const std::vector<Work>& works, const Turns& turns = {});

// The same, but returns only the median of the rounds for each piece of work.
std::vector<double> in_turns_ns(const std::vector<Work>& works, const Turns& turns = {});

// The nanoseconds of one call of a single piece of work.
double time_ns(const Work& work, const Turns& turns = {.rounds = 5, .at_least_ms = 1});

}  // namespace study
