#include <companion/check/sanitized.hpp>

#include "catch.hpp"

using companion::read_sanitizer_report;

namespace {

const std::vector<companion::fs::path> files{"exercises/00_x/rt/canvas.hpp"};

}  // namespace

TEST_CASE("a sanitizer's report names what happened, and the learner's line", "[sanitized]") {
    const auto address = read_sanitizer_report(R"(some output of /c/exercises/00_x/rt/canvas.hpp:9
==7==ERROR: AddressSanitizer: heap-use-after-free on address 0x602 at pc 0x55
READ of size 8 at 0x602 thread T0
    #0 0x55 in std::copy /usr/include/c++/12/bits/stl_algobase.h:385
    #1 0x56 in rt::Canvas<int>::Canvas(rt::Canvas<int> const&) /c/exercises/00_x/rt/canvas.hpp:41:9
    #2 0x57 in main /c/tests/00_x/00.2_canvas.cpp:7
)",
                                               files);
    CHECK(address.what == "heap-use-after-free on address 0x602 at pc 0x55");
    CHECK(address.where == "exercises/00_x/rt/canvas.hpp:41");
    const auto undefined = read_sanitizer_report(
        "/c/exercises/00_x/rt/canvas.hpp:12:5: runtime error: division by zero\n", files);
    CHECK(undefined.what == "division by zero");
    CHECK(undefined.where == "exercises/00_x/rt/canvas.hpp:12");
    const auto from_the_build = read_sanitizer_report(
        "../../exercises/00_x/rt/canvas.hpp:36:15: runtime error: null pointer\n", files);
    CHECK(from_the_build.what == "null pointer");
    CHECK(from_the_build.where == "exercises/00_x/rt/canvas.hpp:36");
    const auto race = read_sanitizer_report(
        "WARNING: ThreadSanitizer: data race (pid=9)\n  #0 f /usr/include/x.h:3\n", files);
    CHECK(race.what == "data race (pid=9)");
    CHECK(race.where == "");
    const auto aborted = read_sanitizer_report(
        "==7==ERROR: AddressSanitizer: ABRT on unknown address 0x1 (pc 0x2)\n    #0 0x3 in abort\n"
        "    #4 0x5 in rt::f() /c/exercises/00_x/rt/canvas.hpp:8:1\n",
        files);
    CHECK(aborted.what.find("was aborted") != std::string::npos);
    CHECK(aborted.where == "exercises/00_x/rt/canvas.hpp:8");
    CHECK(read_sanitizer_report("All tests passed\n", files).what == "");
}
