#ifdef __linux__
#include <sched.h>
#endif

#include <chrono>
#include <companion/check/test_results.hpp>
#include <companion/model/course.hpp>
#include <companion/system/parallel.hpp>
#include <companion/system/process.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <rt/todo.hpp>
#include <thread>

#include "catch.hpp"
#include "pictured.hpp"
#include "processor_time.hpp"
#if __has_include(<catch2/internal/catch_test_failure_exception.hpp>)
#include <catch2/internal/catch_test_failure_exception.hpp>
#endif

namespace {

std::string this_program() {
    return companion::this_course().program("companion_test").string();
}

std::vector<companion::TestCase> read_report(const std::string& lines) {
    return companion::read_report(lines).tests;
}

const std::string report =
    R"(
{"event":"begins","name":"01.1 a < b"}
the tested code prints this, {"and":this}
{"and":"this", "event":5}
[]

{"event":"failed","macro":"CHECK","expression":"computed ==\n    vector<int>{2}","expanded":"3 == 2",)"
    R"("messages":[{"text":"expected 2, actual 3.\nHint: look \"here\"",)"
    R"("expected":"2, ","actual":"3."},{"text":"row 1","if_it_crashes":true}]}

{"event":"failed","messages":[{"text":"FAIL says why"}]}

{"event":"ends","passed":false,"output":""}

{"event":"begins","name":"01.1 second"}

{"event":"ends","passed":true,"output":"here I am\n"}
)";

}  // namespace

TEST_CASE("the events of test cases are read, whatever else is printed", "[test_results]") {
    const auto tests = read_report(report);
    REQUIRE(tests.size() == 2);
    CHECK(tests[0].name == "01.1 a < b");
    CHECK_FALSE(tests[0].passed);
    CHECK(tests[0].ended);
    REQUIRE(tests[0].failures.size() == 2);
    CHECK(tests[0].failures[0].expression == "CHECK( computed == vector<int>{2} )");
    CHECK(tests[0].failures[0].expanded == "3 == 2");
    REQUIRE(tests[0].failures[0].messages.size() == 2);
    const companion::Message& compared = tests[0].failures[0].messages[0];
    CHECK(compared.text == "expected 2, actual 3.\nHint: look \"here\"");
    CHECK(compared.expected == "2");
    CHECK(compared.actual == "3");
    CHECK_FALSE(compared.if_it_crashes);
    CHECK(tests[0].failures[0].messages[1].if_it_crashes);
    CHECK(tests[0].failures[1].expression == "FAIL");
    REQUIRE(tests[0].failures[1].messages.size() == 1);
    CHECK(tests[0].failures[1].messages[0].text == "FAIL says why");
    CHECK(tests[1].passed);
    CHECK(tests[1].output == "here I am");
}

TEST_CASE("an exercise that is missing is known by its number, not by words", "[test_results]") {
    const auto tests = read_report(R"({"event":"begins","name":"01.4 x"}
{"event":"failed","macro":"","expression":"f","expanded":"f","exception":"so it says",)"
                                   R"("missing":"01.1","messages":[]}
{"event":"ends","passed":false,"output":""})");
    REQUIRE(tests.size() == 1);
    CHECK(missing_exercise(tests[0]) == "01.1");
    CHECK(tests[0].failures.at(0).exception == "so it says");
    CHECK(companion::missing_exercise({}) == "");
}

TEST_CASE("a report that ends anywhere is read as far as it goes", "[test_results]") {
    for (std::size_t length = 0; length <= report.size(); ++length)
        REQUIRE(read_report(report.substr(0, length)).size() <= 2);
    const auto cut = read_report(report.substr(0, report.find("{\"event\":\"ends\"") + 20));
    REQUIRE(cut.size() == 1);
    CHECK_FALSE(cut[0].ended);
    CHECK(cut[0].failures.size() == 2);
    CHECK(read_report(report.substr(report.find("{\"event\":\"failed\""))).size() == 1);
}

TEST_CASE("lines without the secret word of the run do not count", "[test_results]") {
    const auto of = [](const std::string& lines) { return companion::read_report(lines, "s3"); };
    const std::string cases = R"({"event":"cases","cases":[{"name":"a","hard":false},)"
                              R"({"name":"b","hard":true}]})",
                      begins = R"({"event":"begins","name":"a","hard":false})";
    const auto theirs = of(cases + "\ns4 " + begins + "\ns3" + begins + "\n s3 " + begins + '\n');
    CHECK(theirs.tests.empty());
    CHECK(theirs.compiled.empty());
    const auto ours = of("noise\ns3 " + cases + "\ns3 " + begins + "\ns3 {\"event\":\"exits\"}\n");
    CHECK(ours.tests.size() == 1);
    CHECK(ours.exited);
    REQUIRE(ours.compiled.size() == 2);
    CHECK(ours.compiled[1].name == "b");
    CHECK(ours.compiled[1].hard);
}

TEST_CASE("what the tested code says is not obeyed by a terminal", "[test_results]") {
    const auto tests = read_report(R"({"event":"begins","name":"x"}
{"event":"failed","exception":"\u001b[31mred\u001b]0;title\u0007","messages":[{"text":"\u001b[2J\u009bgone\b"}]}
{"event":"ends","passed":false,"output":")" +
                                   std::string(100'000, 'x') + "\"}");
    REQUIRE(tests.size() == 1);
    REQUIRE(tests[0].failures.size() == 1);
    CHECK(tests[0].failures[0].exception == "red");
    CHECK(tests[0].failures[0].messages.at(0).text == "gone");
    CHECK(tests[0].output.size() < 5'000);
}

TEST_CASE("a crash is told with the test case in which it came", "[test_results]") {
    const auto tests = read_report(R"({"event":"begins","name":"01.1 x"}
{"event":"crashes","cause":"SIGSEGV - Segmentation violation signal"}
{"event":"ends","passed":false,"output":""})");
    REQUIRE(tests.size() == 1);
    CHECK(tests[0].crash == "SIGSEGV - Segmentation violation signal");
    CHECK_FALSE(tests[0].passed);
    CHECK(tests[0].failures.empty());
}

// What the reporter itself writes: the test cases below run in a process of their own.
TEST_CASE("events: passes and prints", "[.events]") {
    CHECK(true);
    std::printf("no line of its own");
    std::cout << "printed \"so\"\n";
}

TEST_CASE("events: fails", "[.events]") {
    INFO(EXPECTED "1, " ACTUAL "\xff.\nHint: "
         << "actual or expected");
    INFO(IF_IT_CRASHES "call");
    INFO(checkpoint::pictured({3, 5, 9}, {4, 4.5, 9}, 2));
    CHECK(1 + 1 == 1);
    FAIL_CHECK("said aloud");
}

TEST_CASE("events: throws", "[.events]") {
    CHECK(static_cast<bool>(rt::todo("01.1")));
    const std::vector<int> none;
    none.at(3);
}

TEST_CASE("events: needs what is not written", "[.events]") {
    rt::todo("01.2");
}

TEST_CASE("events: z crashes", "[.events]") {
    CHECK(false);
    volatile int* nothing = nullptr;
    *nothing = 1;
}

TEST_CASE("the reporter's lines say all, also of a crash", "[test_results]") {
    const auto result =
        companion::run_process({.command = {this_program(), "[.events]", "-r", "events"},
                                .output = companion::Output::errors_hidden});
#ifdef RT_SANITIZED  // which ends the program itself
    CHECK(result.exit_code != 0);
#else
    CHECK(result.signal == SIGSEGV);
#endif
    const auto tests = read_report(result.output);
    REQUIRE(tests.size() == 5);
    CHECK(tests[0].passed);
    CHECK(tests[0].output == "printed \"so\"");
    REQUIRE(tests[1].failures.size() == 2);
    CHECK_FALSE(tests[1].passed);
    CHECK(tests[1].failures[0].expression == "CHECK( 1 + 1 == 1 )");
    CHECK(tests[1].failures[0].expanded == "2 == 1");
    CHECK(tests[1].failures[0].messages.at(0).text.find("expected 1, actual ") == 0);
    CHECK(tests[1].failures[0].messages.at(0).expected == "1");
    CHECK(tests[1].failures[0].messages.at(0).actual.size() == 3);  // a sign for what is no letter
    CHECK(tests[1].failures[0].messages.at(1).text == "Hint, if this crashes: call");
    CHECK(tests[1].failures[0].messages.at(1).if_it_crashes);
    CHECK(tests[1].failures[0].messages.at(2).text == "");
    CHECK(tests[1].failures[0].messages.at(2).counts == "2;3 5;4 4.5");
    CHECK(tests[1].failures[1].messages.back().text == "said aloud");
    REQUIRE(tests[2].failures.size() == 2);
    CHECK(missing_exercise(tests[2]) == "01.1");
    CHECK(tests[2].failures[1].missing == "");
    CHECK(tests[2].failures[1].exception != "");
    CHECK(missing_exercise(tests[3]) == "01.2");
#ifndef RT_SANITIZED
    CHECK(tests[4].crash.find("SIGSEGV") == 0);
    CHECK(tests[4].failures.size() == 2);
#endif
}

// Ways to end a test case in which nothing has failed.
TEST_CASE("ends: nothing is checked", "[.ends]") {}
TEST_CASE("ends: as Catch2 ends it", "[.ends]") {
    CHECK(true);
    throw Catch::TestFailureException{};
}
TEST_CASE("ends: exit", "[.ends]") {
    CHECK(true);
    std::exit(0);
}
TEST_CASE("ends: all is well", "[.ends]") {
    SECTION("one") {
        CHECK(true);
    }
    SECTION("two") {
        CHECK(true);
    }
}

TEST_CASE("a test case passes only if it came to its end", "[test_results]") {
    const auto ran = [](const std::string& name) {
        const auto result = companion::run_process(
            {.command = {"env", "COURSE_EVENTS=secret", this_program(), name, "-r", "events"},
             .has_events = true});
        CHECK(result.output == "");
        CHECK(result.signal == 0);
        return companion::read_report(result.events, "secret");
    };
    for (const char* const name : {"ends: nothing is checked", "ends: as Catch2 ends it"}) {
        const auto found = ran(name);
        REQUIRE(found.tests.size() == 1);
        CHECK(found.tests[0].ended);
        CHECK_FALSE(found.tests[0].passed);
        CHECK(found.tests[0].failures.size() == 1);
        CHECK(found.compiled.size() > 100);
    }
    const auto exits = ran("ends: exit");
    CHECK(exits.exited);
    REQUIRE(exits.tests.size() == 1);
    CHECK_FALSE(exits.tests[0].ended);
    CHECK(ran("ends: all is well").tests.at(0).passed);
}

#if !defined(RT_SANITIZED) && !__has_include(<catch2/catch_test_macros.hpp>)
namespace {

int endless(int n) {
    volatile char room[1000]{};
    return n < 0 ? 0 : endless(n + 1) + room[0];
}

}  // namespace

TEST_CASE("memory: null", "[.null]") {
    volatile int* nothing = nullptr;
    CHECK(*nothing == 0);
}

TEST_CASE("memory: stack", "[.stack]") {
    INFO("expected 3");
    CHECK(endless(0) == 0);
}

TEST_CASE("endless: loop", "[.endless]") {
    INFO("Hint: which loop never ends?");
    CHECK(true);
    volatile bool on = true;
    while (on) {
    }
}

TEST_CASE("endless: loop that allocates", "[.endless]") {
    for (volatile bool on = true; on;) std::vector<std::vector<char>>(100, std::vector<char>(2000));
}

TEST_CASE("endless: wait", "[.endless]") {
    INFO("Hint: who unlocks it?");
    CHECK(true);
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

TEST_CASE("endless: no end for long", "[.endless]") {
    for (double last = 0; last < 4; last += 0.5) {
        while (checkpoint::processor_seconds() < last) {
        }
        CHECK(true);
    }
}

TEST_CASE("endless: another program for long", "[.endless]") {
    CHECK(std::system("sleep 4") == 0);
}

TEST_CASE("what never ends is stopped, and its hints are kept", "[test_results]") {
    std::vector<std::string> names{"loop", "loop that allocates", "wait", "no end for long"};
#ifndef _WIN32  // where waiting is not noticed
    names.insert(names.end(), {"another program for long", "wait"});
#endif
    constexpr std::size_t timed_out = 2, waits = 5;
    std::vector<companion::Result> results(names.size());
    companion::in_parallel(names.size(), [&](std::size_t i) {
        const std::string name = "endless: " + names[i];
        results[i] = companion::run_process({.command = {this_program(), name, "-r", "events"},
                                             .output = companion::Output::errors_hidden,
                                             .timeout = i == timed_out ? 1.0 : 60.0});
    });
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(names[i]);
        const companion::Result& result = results[i];
        const auto tests = read_report(result.output);
        REQUIRE(tests.size() == 1);
        const bool is_loop = i < 2;
        CHECK(result.timed_out == (i == timed_out));
        CHECK(tests[0].computed == (is_loop ? 3 : 0));
        CHECK(tests[0].waited == (i == waits ? 3 : 0));
        const bool ends = i == 3 || i == 4;
        CHECK(tests[0].passed == ends);
        if (is_loop) {
            CHECK(result.cpu_seconds > 2.5);  // the timer counts whole ticks of a shared core
            CHECK(result.cpu_seconds < 5);
        }
        if (i == 1 || ends) continue;
        REQUIRE(tests[0].failures.size() == 1);
        CHECK(tests[0].failures[0].messages.back().text.rfind("Hint: ", 0) == 0);
    }
}

#ifdef __linux__
TEST_CASE("a loop on a busy machine is not taken for waiting", "[test_results]") {
    // It shares a core with a loop of a higher priority, which leaves it 3 %.
    cpu_set_t cores;
    REQUIRE(sched_getaffinity(0, sizeof cores, &cores) == 0);
    int core = 0;
    while (!CPU_ISSET(core, &cores)) ++core;
    const auto on_one_core = [&](std::vector<std::string> command, double seconds) {
        command.insert(command.begin(), {"taskset", "-c", std::to_string(core)});
        return companion::run_process(
            {.command = command, .output = companion::Output::errors_hidden, .timeout = seconds});
    };
    companion::Result loop;
    companion::in_parallel(2, [&](std::size_t i) {
        if (i == 0)
            on_one_core({"sh", "-c", "while :; do :; done"}, 9);
        else
            loop = on_one_core(
                {"nice", "-n", "15", this_program(), "endless: loop", "-r", "events"}, 8);
    });
    const auto tests = read_report(loop.output);
    REQUIRE(tests.size() == 1);
    CHECK(tests[0].waited == 0);
}
#endif

TEST_CASE("a crash says which memory was used", "[test_results]") {
    for (const std::string memory : {"null", "stack"}) {
        const auto result = companion::run_process(
            {.command = {this_program(), "[." + memory + "]", "-r", "events"},
             .output = companion::Output::errors_hidden});
        CHECK(result.signal == SIGSEGV);
        const auto tests = read_report(result.output);
        REQUIRE(tests.size() == 1);
        CHECK(tests[0].memory == memory);
    }
}
#endif

TEST_CASE("a hard test case is a star", "[test_results]") {
    const auto tests = read_report(R"({"event":"begins","name":"01.4 easy","hard":false}
{"event":"ends","passed":true,"output":""}
{"event":"begins","name":"01.4 star","hard":true}
{"event":"ends","passed":true,"output":""}
{"event":"begins","name":"01.4 of an older program"})");
    REQUIRE(tests.size() == 3);
    CHECK_FALSE(tests[0].hard);
    CHECK(tests[1].hard);
    CHECK_FALSE(tests[2].hard);
}
