#include <chrono>
#include <companion/system/file_lock.hpp>
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

TEST_CASE("what runs aside has a low priority, and no signal ignored", "[process]") {
    const auto priority = [] { return run_process({.command = {"nice"}}).output; };
    const std::string usual = priority();
    {
        const companion::RunsAside aside;
        CHECK(priority() == "10\n");
    }
    CHECK(priority() == usual);
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    CHECK(run_process({.command = {"sh", "-c", "kill -PIPE $$"}}).signal == SIGPIPE);
    std::signal(SIGPIPE, before);
}

TEST_CASE("a process's output is captured in its order, errors too", "[process]") {
    CHECK(run_process({.command = {"sh", "-c", "echo one; echo two >&2; echo three"}}).output ==
          "one\ntwo\nthree\n");
    const auto only_out =
        run_process({.command = {"sh", "-c", "echo one; echo shown by a test >&2"},
                     .output = Output::errors_shown});
    CHECK(only_out.output == "one\n");
    CHECK(run_process({.command = {"sh", "-c", "echo one; echo two >&2; echo three"},
                       .output = Output::errors_only})
              .output == "two\n");
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

TEST_CASE("a process cannot stop the one that waits for it", "[process]") {
    const auto quick =
        run_process({.command = {"sh", "-c", "kill -STOP $PPID; echo said"}, .timeout = 20});
    CHECK(quick.ok());
    CHECK(quick.output == "said\n");
    CHECK(quick.seconds < 10);
    const auto slow = run_process(
        {.command = {"sh", "-c", "while :; do kill -STOP $PPID; done"}, .timeout = 0.3});
    CHECK(slow.timed_out);
    CHECK(slow.seconds < 20);
}

TEST_CASE("a process that leaves a child behind with its output open has still ended",
          "[process]") {
    const auto result = run_process({.command = {"sh", "-c", "sleep 3 & echo done"}});
    CHECK(result.output == "done\n");
    CHECK(result.seconds < 2);
}

#ifdef __linux__
TEST_CASE("nothing that a process started outlives it, wherever it hides", "[process]") {
    const TemporaryFolder folder;
    const std::string late =
        "setsid sh -c 'trap \"\" TERM; (setsid sleep 3; echo x >late) & wait' &";
    CHECK(run_process({.command = {"sh", "-c", late}, .folder = folder.path()}).seconds < 2.9);
    const auto stopped =
        run_process({.command = {"sh", "-c", "trap '' TERM; " + late + " while :; do :; done"},
                     .folder = folder.path(),
                     // long enough for a busy machine to begin both
                     .timeout = 1});
    CHECK(stopped.timed_out);
    CHECK(stopped.signal == SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(3100));
    CHECK(folder.count() == 0);
}

TEST_CASE("a process that may not start another is ended where it does", "[process]") {
    const auto run = [](const std::string& words) {
        return run_process({.command = {"/bin/sh", "-c", words}, .may_start_others = false});
    };
    const auto alone = run("echo alone; exit 3");
    CHECK(alone.output == "alone\n");
    CHECK(alone.exit_code == 3);
    CHECK_FALSE(alone.started_other);
    for (const char* const words : {"/bin/true; exit 0", "exec /bin/true", "(exit 0); exit 0"}) {
        const auto other = run(words);
        CHECK(other.started_other);
        CHECK(how_it_ended(other) == "it was stopped because it started another process");
    }
}
#endif

TEST_CASE("a process is ended when nobody needs it any longer", "[process]") {
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    {
        const companion::EndsRuns ends{[&] { return seconds() > 1; }};
        // It may still tidy up.
        const auto ended = run_process(
            {.command = {"sh", "-c", "trap 'echo tidied; exit 3' TERM; sleep 30 & wait"}});
        CHECK_FALSE(ended.ok());
        CHECK(ended.output == "tidied\n");
        CHECK(seconds() >= 1);
        CHECK(seconds() < 10);
        const companion::EndsRuns never{[] { return false; }};
        CHECK(run_process({.command = {"true"}}).ok());
    }
    CHECK_FALSE(companion::EndsRuns::exists());
    CHECK(run_process({.command = {"sleep", "0.3"}}).ok());
}

TEST_CASE("a lock is held alone or shared", "[process]") {
    using companion::FileLock, companion::Hold;
    const TemporaryFolder folder;
    const auto is_free = [&](Hold hold) {
        return FileLock{folder.path() / "lock", hold, [] { return false; }}.is_held();
    };
    CHECK(is_free(Hold::alone));
    {
        const FileLock lock{folder.path() / "lock", Hold::shared};
        CHECK(is_free(Hold::shared));
        CHECK_FALSE(is_free(Hold::alone));
    }
    const FileLock lock{folder.path() / "lock"};
    CHECK_FALSE(is_free(Hold::shared));
    CHECK_FALSE(is_free(Hold::alone));
}

TEST_CASE("a process has limits of time and files", "[process]") {
    const TemporaryFolder folder;
    CHECK(run_process({.command = {"sh", "-c", "while :; do :; done"}, .most_cpu = 1}).signal ==
          SIGXCPU);
    CHECK(run_process(
              {.command = {"cp", "/bin/sh", "copy"}, .folder = folder.path(), .most_file = 1000})
              .signal == SIGXFSZ);
}

TEST_CASE("a process's events come through a descriptor of their own", "[process]") {
    const auto result =
        run_process({.command = {"sh", "-c", "echo out; echo event >&3"}, .has_events = true});
    CHECK(result.output == "out\n");
    CHECK(result.events == "event\n");
}

TEST_CASE("a program is looked up in PATH", "[process]") {
    CHECK(companion::is_installed("sh"));
    CHECK_FALSE(companion::is_installed("no-such-program-here"));
}
