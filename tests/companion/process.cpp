#include <chrono>
#include <companion/system/process.hpp>
#include <csignal>
#include <thread>

#include "catch.hpp"
#include "temporary_folder.hpp"

using checkpoint::read_file;
using checkpoint::TemporaryFolder;
using companion::Output;
using companion::run_process;

TEST_CASE("a process gets its arguments as they are", "[process]") {
    const std::string odd = "a b; echo $HOME `id` \"quoted\" 'x' *\n\\";
    CHECK(run_process({.command = {"printf", "%s|", odd, "", "z"}}).output == odd + "||z|");
}

TEST_CASE("a process's exit code and signal come back", "[process]") {
    CHECK(run_process({.command = {"true"}}).ok());
    const auto seven = run_process({.command = {"sh", "-c", "exit 7"}});
    CHECK(seven.exit_code == 7);
    CHECK_FALSE(seven.ok());
    CHECK(how_it_ended(seven) == "exit code 7");
    const auto killed = run_process({.command = {"sh", "-c", "kill -SEGV $$"}});
    CHECK(killed.signal == SIGSEGV);
    CHECK_FALSE(killed.ok());
    CHECK(how_it_ended(killed).rfind("signal 11", 0) == 0);
    const auto missing = run_process({.command = {"no-such-program-here"}});
    CHECK(missing.exit_code == 127);
    CHECK(how_it_ended(missing) == "it could not be started");
}

TEST_CASE("a process's output is captured in its order, errors too", "[process]") {
    CHECK(run_process({.command = {"sh", "-c", "echo one; echo two >&2; echo three"}}).output ==
          "one\ntwo\nthree\n");
    const auto only_out =
        run_process({.command = {"sh", "-c", "echo one; echo shown by a test >&2"},
                     .output = Output::errors_shown});
    CHECK(only_out.output == "one\n");
}

TEST_CASE("a lot of output arrives whole", "[process]") {
    const auto result = run_process(
        {.command = {"sh", "-c", "i=0; while [ $i -lt 20000 ]; do echo $i; i=$((i+1)); done"}});
    CHECK(result.output.size() == 108890);
    CHECK(result.output.substr(result.output.size() - 6) == "19999\n");
}

TEST_CASE("a process runs in the folder that was asked for, with nothing to read", "[process]") {
    const TemporaryFolder folder;
    CHECK(
        run_process({.command = {"sh", "-c", "echo x >file; cat"}, .folder = folder.path()}).ok());
    CHECK(read_file(folder / "file") == "x\n");
    CHECK(run_process({.command = {"true"}, .folder = folder / "missing"}).exit_code == 127);
}

TEST_CASE("a process that takes too long is ended with all that it started", "[process]") {
    const TemporaryFolder folder;
    const auto result =
        run_process({.command = {"sh", "-c", "echo before; (sleep 1; echo x >late) & wait"},
                     .folder = folder.path(),
                     .timeout = 0.2});
    CHECK(result.timed_out);
    CHECK_FALSE(result.ok());
    CHECK(result.output == "before\n");
    CHECK(result.seconds >= 0.2);
    CHECK(result.seconds < 0.9);
    CHECK(how_it_ended(result) == "it timed out after 0 s");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    CHECK(folder.count() == 0);
}

TEST_CASE("a process that leaves a child behind with its output open has still ended",
          "[process]") {
    const auto result = run_process({.command = {"sh", "-c", "sleep 3 & echo done"}});
    CHECK(result.output == "done\n");
    CHECK(result.seconds < 2);
}

TEST_CASE("a program is looked up in PATH", "[process]") {
    CHECK(companion::is_installed("sh"));
    CHECK_FALSE(companion::is_installed("no-such-program-here"));
}
