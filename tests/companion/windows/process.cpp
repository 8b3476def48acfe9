#include <windows.h>

#include <app/errors.hpp>
#include <app/signals.hpp>
#include <atomic>
#include <chrono>
#include <companion/system/file_lock.hpp>
#include <companion/system/keyboard.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <companion/system/scratch_folder.hpp>
#include <set>
#include <thread>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using companion::Crash;
using companion::crash_of;
using companion::Output;
using companion::Result;
using companion::Run;
using companion::run_process;

namespace {

// Runs odd_program as the rest of `run` says.
Result odd(const std::vector<std::string>& words, Run run = {.command = {}}) {
    run.command.push_back(ODD_PROGRAM);
    run.command.insert(run.command.end(), words.begin(), words.end());
    return run_process(run);
}

void wait(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

}  // namespace

TEST_CASE("a process gets its arguments as they are", "[process]") {
    const std::string strange = "a b; echo %PATH% \"quoted\" 'x' *\\\" \\\\",
                      end = "back\\slash\\ \\";
    CHECK(odd({"print", strange, "", end, "\\", "z"}).output == strange + "||" + end + "|\\|z|");
}

TEST_CASE("a process's exit code and crash come back", "[process]") {
    CHECK(odd({"exit", "0"}).ok());
    const Result seven = odd({"exit", "7"});
    CHECK(seven.exit_code == 7);
    CHECK_FALSE(seven.ok());
    CHECK(how_it_ended(seven) == "exit code 7");
    const auto check = [](const std::string& how, Crash crash, const std::string& words) {
        INFO(how);
        const Result result = odd({"crash", how});
        CHECK(crash_of(result.signal) == crash);
        CHECK_FALSE(result.ok());
        CHECK(how_it_ended(result).find(words) != std::string::npos);
    };
    check("null", Crash::memory, "(access violation)");
    check("stack", Crash::memory, "(access violation)");
    check("divide", Crash::division, "(integer division by zero)");
    check("code", Crash::invalid_code, "(illegal instruction)");
    const Result missing = run_process({.command = {"no-such-program-here"}});
    CHECK(missing.exit_code == 127);
    CHECK(how_it_ended(missing) == "it could not be started");
}

TEST_CASE("a process's output is captured in its order, errors too", "[process]") {
    CHECK(odd({"both"}).output == "one\ntwo\nthree\n");
    CHECK(odd({"both"}, {.command = {}, .output = Output::errors_shown}).output == "one\nthree\n");
    CHECK(odd({"both"}, {.command = {}, .output = Output::errors_hidden}).output == "one\nthree\n");
    CHECK(odd({"both"}, {.command = {}, .output = Output::errors_only}).output == "two\n");
}

TEST_CASE("a lot of output arrives whole, or is cut", "[process]") {
    const Result result = odd({"count", "20000"});
    CHECK(result.output.size() == 108890);
    CHECK(result.output.substr(result.output.size() - 6) == "19999\n");
    const Result cut = odd({"count", "2000000000"}, {.command = {}, .most_output = 1 << 20});
    CHECK(cut.too_much);
    CHECK_FALSE(cut.ok());
}

TEST_CASE("a process runs in the folder that was asked for, with nothing to read", "[process]") {
    const TemporaryFolder folder;
    CHECK(odd({"write", "file"}, {.command = {}, .folder = folder.path()}).ok());
    CHECK(read_file(folder / "file") == "x\n");
    CHECK(odd({"read"}).output.empty());
    CHECK(odd({"exit", "0"}, {.command = {}, .folder = folder / "missing"}).exit_code == 127);
}

TEST_CASE("a process has the variables that were asked for", "[process]") {
    CHECK(run_process({.command = {"env", "ONE=1", "TWO=a=b c", ODD_PROGRAM, "variable", "TWO"}})
              .output == "a=b c");
}

TEST_CASE("a process that takes too long is ended with all that it started", "[process]") {
    const TemporaryFolder folder;
    const Result result = odd({"start_and_wait", "late", "file"},
                              {.command = {}, .folder = folder.path(), .timeout = 0.5});
    CHECK(result.timed_out);
    CHECK_FALSE(result.ok());
    CHECK(result.output == "before\n");
    CHECK(result.seconds >= 0.5);
    CHECK(result.seconds < 3);
    wait(1500);
    CHECK(folder.count() == 0);
}

TEST_CASE("a process that leaves a child behind with its output open has still ended",
          "[process]") {
    const TemporaryFolder folder;
    CHECK(odd({"start", "late", "file"}, {.command = {}, .folder = folder.path()}).ok());
    wait(1500);
    CHECK(folder.count() == 0);
}

TEST_CASE("a process has a limit of processor time", "[process]") {
    const Result result = odd({"loop"}, {.command = {}, .timeout = 20, .most_cpu = 1});
    CHECK_FALSE(result.timed_out);
    CHECK(how_it_ended(result).find("too much processor time") != std::string::npos);
    CHECK(result.cpu_seconds > 0.9);
}

TEST_CASE("a process's events come through a descriptor of their own", "[process]") {
    const Result result = odd({"event"}, {.command = {}, .has_events = true});
    CHECK(result.ok());
    CHECK(result.output.empty());
    CHECK(result.events == "event\n");
}

TEST_CASE("processes run at the same time, and each has its own output", "[process]") {
    std::vector<std::thread> threads;
    std::vector<std::string> outputs(6);
    for (std::size_t i = 0; i < outputs.size(); ++i)
        threads.emplace_back([&, i] {
            outputs[i] = odd({"print", std::to_string(i)}, {.command = {}, .timeout = 30}).output;
        });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < outputs.size(); ++i) CHECK(outputs[i] == std::to_string(i) + '|');
}

TEST_CASE("a program that is held is started a moment later", "[process]") {
    const TemporaryFolder folder;
    const std::filesystem::path program = folder / "held.exe";
    std::filesystem::copy_file(ODD_PROGRAM, program);
    const HANDLE held = ::CreateFileW(program.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr,
                                      OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
    REQUIRE(held != INVALID_HANDLE_VALUE);
    std::thread release{[&] {
        wait(300);
        ::CloseHandle(held);
    }};
    const Result result = run_process({.command = {program.string(), "exit", "7"}});
    release.join();
    CHECK(result.exit_code == 7);
}

TEST_CASE("a program is looked up in PATH", "[process]") {
    CHECK(companion::is_installed("cmd"));
    CHECK_FALSE(companion::is_installed("no-such-program-here"));
}

TEST_CASE("a scratch folder goes with its object", "[process]") {
    std::filesystem::path path;
    {
        const companion::ScratchFolder folder{"course-test"};
        path = folder.path();
        checkpoint::write_file(path / "file", "x");
        CHECK(std::filesystem::exists(path / "file"));
    }
    CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("a lock is held by one at a time", "[process]") {
    const TemporaryFolder folder;
    std::atomic<bool> has_both = false;
    std::thread other;
    {
        const companion::FileLock lock{folder / "lock"};
        other = std::thread{[&] {
            const companion::FileLock second{folder / "lock"};
            has_both = true;
        }};
        wait(100);
        CHECK_FALSE(has_both);
    }
    other.join();
    CHECK(has_both);
}

TEST_CASE("keys come through a pipe, until its other end is closed", "[process]") {
    const HANDLE before = ::GetStdHandle(STD_INPUT_HANDLE);
    HANDLE from = nullptr, into = nullptr;
    REQUIRE(::CreatePipe(&from, &into, nullptr, 0));
    ::SetStdHandle(STD_INPUT_HANDLE, from);
    companion::Keyboard keyboard{true};
    CHECK_FALSE(keyboard.key(50));
    DWORD count = 0;
    REQUIRE(::WriteFile(into, "hq", 2, &count, nullptr));
    CHECK(keyboard.key(1000) == 'h');
    CHECK(keyboard.key(1000) == 'q');
    CHECK_FALSE(keyboard.at_end());
    ::CloseHandle(into);
    CHECK_FALSE(keyboard.key(50));
    CHECK(keyboard.at_end());
    ::SetStdHandle(STD_INPUT_HANDLE, before);
    ::CloseHandle(from);
}

TEST_CASE("a signal calls all actions and then ends the program", "[process]") {
    for (const int signal : app::ending_signals) {
        const Result result = odd({"raise", std::to_string(signal)});
        CHECK(result.output == "ab");
        CHECK(result.exit_code == 128 + signal);
    }
}

TEST_CASE("the second signal ends a program that has noted the first", "[process]") {
    for (const int second : {SIGINT, SIGTERM})
        CHECK(odd({"raise twice", std::to_string(second)}).exit_code == 128 + second);
}

TEST_CASE("a stub that a thread reaches is named", "[process]") {
    const Result result = odd({"todo"});
    CHECK(result.exit_code == app::still_to_write);
    CHECK(result.output.rfind("odd_program: exercise 01.2", 0) == 0);
}

TEST_CASE("a file that is saved twice within a second was saved twice", "[process]") {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "saved.hpp";
    CHECK_FALSE(companion::last_written(file));
    std::set<std::int64_t> times;
    for (int i = 0; i < 3; ++i) {
        checkpoint::write_file(file, "the same");
        times.insert(companion::last_written(file).value());
        wait(50);
    }
    CHECK(times.size() == 3);
}

TEST_CASE("a line is taken apart as CMake writes it on Windows", "[process]") {
    CHECK(companion::command_words(
              R"(C:\ucrt64\bin\c++.exe  -DA=\"b c\" "-IC:/José M" -o x.dir\a.obj -c C:\a.cpp)") ==
          std::vector<std::string>{"C:\\ucrt64\\bin\\c++.exe", "-DA=\"b", "c\"", "-IC:/José M",
                                   "-o", "x.dir\\a.obj", "-c", "C:\\a.cpp"});
}
