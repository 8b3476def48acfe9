#include <app/errors.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/model/state.hpp>
#include <companion/system/files.hpp>
#include <companion/system/terminal.hpp>
#include <thread>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

TEST_CASE("what is remembered comes back", "[state]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    CHECK(read_state(course).exercises.empty());
    CHECK(folder.count() == 0);  // reading makes nothing
    change_state(course, [](State& state) { state.exercises["01.1"] = {true, "abc", 2}; });
    const State state = read_state(course);
    REQUIRE(state.exercises.size() == 1);
    CHECK(state.exercises.at("01.1").passed);
    CHECK(state.exercises.at("01.1").hash == "abc");
    CHECK(state.exercises.at("01.1").hints == 2);
}

TEST_CASE("a state without stars is read, and stars come back", "[state]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    write_file(
        folder / ".course/state.json",
        R"({"version": 1, "exercises": {"01.1": {"passed": true, "hash": "a", "hints": 1}}})");
    CHECK(read_state(course).exercises.at("01.1").passed);
    CHECK(read_state(course).exercises.at("01.1").open_stars == 0);
    change_state(course, [](State& state) {
        state.exercises["01.1"].stars = 3;
        state.exercises["01.1"].open_stars = 2;
    });
    CHECK(read_state(course).exercises.at("01.1").stars == 3);
    CHECK(read_state(course).exercises.at("01.1").open_stars == 2);
}

TEST_CASE("when an answer passed first comes back, and older states do not know it", "[state]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    write_file(folder / ".course/state.json",
               R"({"version": 1, "exercises": {"01.1": {"passed": true, "hash": "a", "hints": 1},
            "01.2": {"passed": false, "hash": "b", "hints": 0}},
            "own": {"folder": "x", "hash": "c", "lines": 3, "passed": 3}})");
    CHECK(read_state(course).exercises.at("01.1").first_passed == unknown_time);
    CHECK(read_state(course).exercises.at("01.2").first_passed == 0);
    CHECK(read_state(course).own.first_passed == unknown_time);
    change_state(course, [](State& state) {
        state.exercises["01.2"].first_passed = 5'000'000'000;
        state.drawn = {"d", {"01.1", "01.2"}};
    });
    const State state = read_state(course);
    CHECK(state.exercises.at("01.1").first_passed == unknown_time);
    CHECK(state.exercises.at("01.2").first_passed == 5'000'000'000);
    CHECK(state.drawn.hash == "d");
    CHECK(state.drawn.yours == std::vector<std::string>{"01.1", "01.2"});
}

TEST_CASE("a state that is broken or of another version is set aside", "[state]") {
    for (const char* const text :
         {"", "{", "[]", "null", "{\"version\": 0, \"exercises\": {}}",
          "{\"version\": 99, \"exercises\": {}}", "{\"version\": 1}",
          "{\"version\": \"1\", \"exercises\": {}}",
          "{\"version\": 1, \"exercises\": {\"01.1\": {\"passed\": 1}}}", "\xff\xfe\x00garbage"}) {
        const TemporaryFolder folder;
        const Course course{folder.path(), folder / "build"};
        write_file(folder / ".course/state.json", text);
        CHECK(read_state(course).exercises.empty());
        CHECK_FALSE(fs::exists(folder / ".course/state.json"));
        CHECK(read_file(folder / ".course/state.broken-1.json") == text);
        change_state(course, [](State& state) { state.exercises["01.1"].hints = 1; });
        CHECK(read_state(course).exercises.at("01.1").hints == 1);
        // The next one does not overwrite the first.
        write_file(folder / ".course/state.json", text);
        CHECK(read_state(course).exercises.empty());
        CHECK(fs::exists(folder / ".course/state.broken-2.json"));
    }
}

TEST_CASE("no change is lost when several are made at once", "[state]") {
    const TemporaryFolder folder;
    const Course course{folder.path(), folder / "build"};
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < 20; ++k)
                change_state(course, [](State& state) { ++state.exercises["01.1"].hints; });
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(read_state(course).exercises.at("01.1").hints == 160);
}

TEST_CASE("a state that cannot be kept is said in one line", "[state]") {
    const TemporaryFolder folder;
    write_file(folder / ".course", "a file");
    const Course course{folder.path(), folder / "build"};
    CHECK(read_state(course).exercises.empty());
    CHECK_THROWS_AS(change_state(course, [](State&) {}), app::Failure);
}

TEST_CASE("the first error of a build is found", "[state]") {
    const Course course{"/a b/course", "/a b/course/build"};
    CHECK(first_error(course,
                      "[1/2] Building\nFAILED: x.o\n/usr/bin/c++ -c /a b/course/tests/x.cpp\n"
                      "In file included from /a b/course/tests/x.cpp:1:\n"
                      "/a b/course/exercises/01_vectors/rt/dot.hpp:10:5: error: expected ';'\n"
                      "   10 |     return 1\n      |             ^\nx.cpp:3:1: error: second\n") ==
          "exercises/01_vectors/rt/dot.hpp:10:5: error: expected ';'\n   10 |     return 1\n"
          "      |             ^");
    CHECK(first_error(course, "../exercises/a.hpp:1:1: fatal error: no such file\nx") ==
          "exercises/a.hpp:1:1: fatal error: no such file");
    CHECK(first_error(course,
                      "/usr/bin/ld: x.o: in function `main':\nx.cpp:(.text+0x1): undefined "
                      "reference to `rt::dot(rt::Vec3)'\n") ==
          "the linker says: undefined reference to `rt::dot(rt::Vec3)'");
    CHECK(first_error(course, "ninja: no work to do.\n") == "");
}

TEST_CASE("bars and lines fit", "[state]") {
    CHECK(bar(0, 7, 10) == "[..........]");
    CHECK(bar(7, 7, 10) == "[##########]");
    CHECK(bar(1, 2, 10) == "[#####.....]");
    CHECK(bar(0, 0, 2) == "[..]");
    CHECK(wrapped("one two three", "  ", 9) == "  one two\n  three\n");
    CHECK(wrapped("a-word-that-is-too-long b", "", 5) == "a-word-that-is-too-long\nb\n");
    CHECK(wrapped("", "  ") == "");
}
