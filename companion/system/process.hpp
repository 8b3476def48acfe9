#pragma once
// Running other programs.

#include <filesystem>
#include <string>
#include <vector>

namespace companion {

// Where what a program prints goes.
enum class Output {
    shown,      // where the companion's own output goes
    printable,  // the same; but what goes to a terminal from stdout is printable, and cut at 1 MB
    captured,   // into Result::output
    errors_shown,  // stdout captured, stderr shown
    errors_hidden  // stdout captured, stderr dropped
};

struct Run {
    // The program, then its arguments; no shell reads them, so they may hold anything. A program
    // without a slash in its name is looked up in PATH. The word env and some NAME=VALUE may stand
    // before it, on all systems.
    std::vector<std::string> command;
    std::filesystem::path folder = ".";  // in which it runs
    Output output = Output::captured;
    // It may write to the descriptor 3, too, which comes into Result::events.
    bool has_events = false;
    // SIGINT and SIGTERM are passed on to the program, which may want to keep what is done, and the
    // companion waits for it; otherwise they end the program and the companion at once. (On
    // Windows Ctrl-C goes to both anyway.)
    bool passes_signals = false;
    // False: it is ended where it starts another process, if the system can tell. It is then named
    // with its folder.
    bool may_start_others = true;
    double timeout = 0;   // seconds after which it is asked to end, then killed; 0 is never
    double most_cpu = 0;  // seconds of processor time that each of its processes may take; 0 is any
    std::size_t most_memory = 0;  // bytes that each may have, if the system can tell; 0 is any
    // Bytes of a file that it may write, if the system can tell; 0 is any.
    std::size_t most_file = 0;
    std::size_t most_output = 0;  // bytes of captured output after which it is ended; 0 is never
};

struct Result {
    int exit_code = 0;  // 127 if the program could not be started
    int signal = 0;     // that ended it, else 0; on Windows, the one that stands for its exception
    int passed_on = 0;  // the last signal that was passed on to it, else 0
    bool timed_out = false;
    bool too_much = false;       // output: the rest is lost
    bool started_other = false;  // which it may not
    double seconds = 0;          // of wall time
    double cpu_seconds = 0;      // of processor time, of all its threads
    std::string output, events;

    bool ok() const { return exit_code == 0 && signal == 0 && !timed_out && !too_much; }
};

// Runs a program to its end. Its standard input is empty, and it has no terminal but through what
// it inherits. Nothing that it started outlives it. An interruption of the companion ends it, too,
// or is passed on to it. Threads may run programs at the same time. Throws std::system_error if the
// system refuses another process.
Result run_process(const Run& run);

// Most processor time in seconds, and most memory in bytes, of a compiler: code may ask it for more
// than there is. The memory is half of the machine's, from 1 to 4 GB.
inline constexpr double most_compiling = 300;
std::size_t memory_of_compiler();

// Of the whole machine, in bytes; 0 if the system does not tell.
std::size_t memory_of_machine();

// The kind of crash that a signal tells.
enum class Crash { none, memory, division, aborted, invalid_code, other };
Crash crash_of(int signal);

// "Segmentation fault".
std::string name_of_signal(int signal);

// How a run ended, for a person: "exit code 2", "it timed out after 20 s", "signal 11 (Segmentation
// fault)".
std::string how_it_ended(const Result& result);

// True if a program of this name is in PATH.
bool is_installed(const std::string& program);

}  // namespace companion
