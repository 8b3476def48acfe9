#pragma once
// Runs other programs.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace companion {

// Where a program's output goes.
enum class Output {
    shown,          // where the companion's own output goes
    printable,      // the same, but on a terminal stdout is made printable, and cut off at 1 MB
    captured,       // into Result::output
    errors_shown,   // stdout captured, stderr shown
    errors_hidden,  // stdout captured, stderr dropped
    errors_only     // stderr captured, stdout dropped
};

struct Run {
    // The program, then its arguments. No shell reads them, so they may contain anything. If the
    // program's name has no slash, it is looked up in PATH. On all systems, the word env and some
    // NAME=VALUE may stand before the program.
    std::vector<std::string> command;
    std::filesystem::path folder = ".";  // the program runs in it
    Output output = Output::captured;
    // The program may also write to descriptor 3; what it writes becomes Result::events.
    bool has_events = false;
    // If true, SIGINT and SIGTERM are passed on to the program, which may want to save what is
    // done, and the companion waits for it. Otherwise they end both at once. (On Windows, Ctrl-C
    // goes to both in any case.)
    bool passes_signals = false;
    // If false, the program is ended when it starts another process, if the system can detect that.
    // Then the program must be named with its folder.
    bool may_start_others = true;
    double timeout = 0;   // seconds until it is asked to end, and soon after killed; 0: never
    double most_cpu = 0;  // seconds of processor time for each of its processes; 0: no limit
    std::size_t most_memory = 0;  // bytes for each process, if the system can tell; 0: no limit
    // The largest file in bytes that it may write, if the system can limit that; 0: no limit.
    std::size_t most_file = 0;
    std::size_t most_output = 0;  // bytes of captured output after which it is ended; 0: never
};

struct Result {
    int exit_code = 0;                 // 127 if the program could not be started
    std::string why_not_started = {};  // in the system's words, if it has any
    int signal = 0;     // that ended it, or 0; on Windows, the one that its exception stands for
    int passed_on = 0;  // the last signal that was passed on to it, or 0
    bool timed_out = false;
    bool too_much = false;       // there was too much output; the rest is lost
    bool started_other = false;  // it was ended because it started another process
    double seconds = 0;          // of wall time
    double cpu_seconds = 0;      // of processor time, of all its threads
    std::string output, events;

    bool ok() const { return exit_code == 0 && signal == 0 && !timed_out && !too_much; }
};

// Runs a program to its end. Its standard input is empty, and it can reach a terminal only through
// the output that it inherits. Nothing that it started outlives it. If the companion is
// interrupted, the program ends, too, or the interruption is passed on to it. Several threads may
// run programs at the same time. Throws std::system_error if the system allows no further process.
Result run_process(const Run& run);

// While one of these exists, each program that runs is asked to end, and soon after killed, once
// `is_over` says that nobody needs it any longer. It is asked ten times a second, by any thread.
class EndsRuns {
  public:
    explicit EndsRuns(std::function<bool()> is_over);
    ~EndsRuns();
    EndsRuns(const EndsRuns&) = delete;
    EndsRuns& operator=(const EndsRuns&) = delete;

    static bool is_over();  // false if there is none
    static bool exists();

  private:
    std::function<bool()> before_;  // of the one that this one replaces meanwhile
};

// While one of these exists, each program that starts runs at low priority: whatever else the
// learner waits for goes before it.
class RunsAside {
  public:
    RunsAside();
    ~RunsAside();
    RunsAside(const RunsAside&) = delete;
    RunsAside& operator=(const RunsAside&) = delete;

    static bool exists();

  private:
    bool before_;  // whether there was another one
};

// The most processor time in seconds, and the most memory in bytes, for a compiler, because code
// can make it need any amount. The memory limit is half of the machine's memory, but at least 1 and
// at most 4 GB.
inline constexpr double most_compiling = 300;
std::size_t memory_of_compiler();

// The machine's memory in bytes; 0 if the system does not say.
std::size_t memory_of_machine();

// The kind of crash that a signal stands for.
enum class Crash { none, memory, division, aborted, invalid_code, other };
Crash crash_of(int signal);

// The name of a signal in words: "Segmentation fault".
std::string name_of_signal(int signal);

// How a run ended, in words for the learner: "exit code 2", "it timed out after 20 s", "signal 11
// (Segmentation fault)".
std::string how_it_ended(const Result& result);

// True if a program of this name is in PATH.
bool is_installed(const std::string& program);

}  // namespace companion
