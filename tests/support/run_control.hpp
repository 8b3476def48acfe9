#pragma once
// What main.cpp asks of the operating system: posix/ and windows/ have the same functions, and
// main.cpp has write_line for both.

#include <csignal>
#include <cstddef>

namespace checkpoint {

// The secret word of this run, which the environment holds no longer; empty without one.
const char* secret_word();

// Writes all of it, whatever the file takes at once.
void write_line(int file, const char* line, std::size_t size);

// Where events go with a secret word, and without.
inline constexpr int events_file = 3, standard_output = 1;

// From now on a crash is told before it ends the program: with the name of the signal by which
// Catch2 knows it, and with the forbidden memory that was used: "null" of a null pointer, "stack"
// below a full stack, or "". Signals are left to Catch2 where it tells them itself.
using Tell = void (*)(const char* signal, const char* memory);
void tell_crashes(Tell tell, bool catch_tells_signals);

// From now on the program is ended when `step` stays the same for this many seconds. If its threads
// compute for so long, taken together, the tested code is in an endless loop. If no thread computes
// and no child process is left, they all wait for something that never comes. Then this event is
// written to the file, and the end is told as that by a signal. A busy machine does not matter.
// (On Windows, waiting is not noticed.)
struct Stuck {
    int file;
    int seconds;
    const char *computes, *waits;  // the events
};
void end_when_stuck(const volatile std::sig_atomic_t& step, const Stuck& stuck);

// Calls this function when the program ends by exit(), except in a process that it forked.
void at_exit(void (*call)());

// What main() does last: ends the program with this exit code, or returns it.
int end_program(int code);

}  // namespace checkpoint
