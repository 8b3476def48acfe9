#pragma once
// Runs code that may end the program, so that the checkpoint survives it; and whole programs.

#include <cstddef>
#include <functional>
#include <string>

namespace checkpoint {

// Runs work() where it may crash, with the usual 8 MiB of stack or less and for at most this many
// seconds, and returns its text; "the program ended" if it did not come to its end, "an exception"
// if it threw one. If it computes nothing for 3 seconds, it is ended, too.
std::string in_own_process(const std::function<std::string()>& work, unsigned seconds = 20,
                           std::size_t stack = std::size_t{8} << 20);

// Leaves this process only a little more address space: enough for a few threads. Returns false
// where that is impossible: under sanitizers, and where there is no /proc.
bool leave_room_for_few_threads();

struct Printed {
    std::string text;
    std::string trouble;  // why it did not finish, or empty
};

// Runs a program without input, for three seconds of processor time and ten seconds at most, and
// takes up to 64 MiB of what it prints.
Printed run_program(const std::string& program);

// What `trouble` says.
namespace trouble {
inline constexpr const char* too_much =
    "it printed more than 64 MiB and was stopped; does a loop never end?";
inline constexpr const char* endless =
    "it computed for 3 seconds without ending; does a loop never end?";
inline constexpr const char* waits =
    "it was still running after 10 seconds; what does it wait for?";
inline constexpr const char* not_started = "it could not be started";
inline std::string crashed(const std::string& how) {
    return "it crashed (" + how + "); does it use an array past its end?";
}
}  // namespace trouble

}  // namespace checkpoint
