// Judging programs that are shell scripts.

#include <app/errors.hpp>
#include <companion/model/course.hpp>
#include <companion/own/judge.hpp>
#include <companion/own/own_program.hpp>
#include <companion/own/scenes.hpp>

#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace companion;
using checkpoint::TemporaryFolder;
using checkpoint::write_file;

namespace {

fs::path our_program() {
    return this_course().program("09_own_solution");
}

// What is said of a program that is this shell script.
std::vector<JudgedLine> verdict_on(const std::string& build, const std::string& part,
                                   double patience = 60) {
    const TemporaryFolder folder;
    if (!build.empty()) write_file(folder / "build.sh", build);
    std::vector<JudgedLine> lines;
    JudgeRequest request{folder.path(), our_program(), 1, part};
    request.patience = patience;
    judge(request, [&](const JudgedLine& line) { lines.push_back(line); });
    return lines;
}

std::string program(const std::string& script) {
    return "echo '#!/bin/sh' >own; echo '" + script + "' >>own; chmod +x own\n";
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a program that cannot be built is one line", "[own]") {
    const auto only = [](const std::string& build) {
        const auto lines = verdict_on(build, "step1");
        REQUIRE(lines.size() == 1);
        CHECK_FALSE(lines[0].passed);
        CHECK(lines[0].actual.find('\n') == std::string::npos);
        return lines[0].actual;
    };
    CHECK(holds(only(""), "there is no build.sh"));
    CHECK(holds(only("echo first; echo 'main.cpp:3:1: error: what' >&2; exit 1\n"),
                "main.cpp:3:1: error: what"));
    CHECK(holds(only("true\n"), "did not make a program named own"));
    // As `own new` leaves it.
    CHECK(holds(only("c++ -x c++ /dev/null -o own\n"), "there is no main() yet"));
}

TEST_CASE("a tracer that draws nothing is not called own", "[own]") {
    const TemporaryFolder folder;
    const fs::path tracer = folder / "tracer";
    write_file(tracer, "#!/bin/sh\n");
    fs::permissions(tracer, fs::perms::owner_all);
    const OwnProgram program{OwnProgram::Existing{}, tracer};
    std::string said;
    try {
        program.picture("", {});
    } catch (const app::Failure& failure) {
        said = failure.what();
    }
    CHECK(said == "your tracer ended with exit code 0 but wrote no picture");
}

TEST_CASE("a program that draws nothing fails line by line", "[own]") {
    CHECK(holds(verdict_on(program("exit 0"), "step1").at(0).actual, "wrote no picture"));
    CHECK(holds(verdict_on(program("echo too hard; exit 4"), "step1").at(0).actual,
                "own: exit code 4: too hard"));
    CHECK(holds(verdict_on(program("echo picture >$2"), "step1").at(0).actual, "P3 or P6"));
    CHECK(holds(verdict_on(program("kill -SEGV $$"), "step1").at(0).actual, "signal 11"));
    const JudgedLine small = verdict_on(program("printf \"P3 1 1 255 0 0 0\" >$2"), "step1").at(0);
    CHECK(holds(small.actual, "different size"));
    // A person may look at it, too.
    CHECK(small.looked.scene == task_steps(1)[0].scenes[0].text);
    REQUIRE(small.looked.pictures);
    CHECK(small.looked.pictures->mine.back().pixels() == 1);
}

#ifdef __linux__
TEST_CASE("a program that runs another is refused", "[own]") {
    for (const char* const script : {"cp /dev/null $2", "exec cp /dev/null $2", "(exit 4)"})
        CHECK(verdict_on(program(script), "step1").at(0).actual ==
              "own: it was stopped because it started another process");
}
#endif

TEST_CASE("a program cannot write a picture of any size", "[own]") {
    const std::string blocks = std::to_string(most_picture / 512);  // as the shell counts
    CHECK(verdict_on(program("ulimit -f; exit 4"), "step1").at(0).actual ==
          "own: exit code 4: " + blocks);
}

TEST_CASE("a program that does not end is not waited for forever", "[own]") {
    const auto lines = verdict_on(program("while :; do :; done"), "hard", 0.2);
    REQUIRE(lines.size() == 3);
    CHECK(holds(lines[0].actual, "it timed out"));
    CHECK(holds(lines[1].actual, "it timed out"));
    CHECK(lines[2].what == "the rest");
}

TEST_CASE("a refusal is one line and an exit code", "[own]") {
    const auto fails = [](const std::string& script) {
        const auto lines = verdict_on(program(script), "broken");
        return std::count_if(lines.begin(), lines.end(),
                             [](const JudgedLine& line) { return !line.passed; });
    };
    CHECK(fails("echo wrong >&2; exit 2") == 0);
    for (const char* const script : {"echo wrong >&2; echo and more >&2; exit 1", "exit 1",
                                     "echo wrong >&2", "kill -ABRT $$", "echo wrong; exit 1"})
        CHECK(fails(script) == static_cast<long>(broken_scenes().size() + broken_limits().size() +
                                                 broken_calls().size()));
}

TEST_CASE("accuracy asks for two choices and for the measured figures", "[own]") {
    const TemporaryFolder folder;
    // With an option, it draws the same picture.
    write_file(folder / "build.sh", program("printf \"P3 1 1 255 0 0 0\" >$2"));
    const auto lines = [&](const std::string& page) {
        write_file(folder / "accuracy.md", page);
        std::vector<JudgedLine> all;
        judge({folder.path(), our_program(), 1, "accuracy"},
              [&](const JudgedLine& line) { all.push_back(line); });
        return all;
    };
    const auto none = lines("");
    REQUIRE(none.size() == 1);
    CHECK_FALSE(none[0].passed);
    const auto one = lines("option: -DX\ntime: 9\nerror: 0.5\n");
    REQUIRE(one.size() == 2);
    CHECK_FALSE(one[0].passed);
    CHECK_FALSE(one[1].passed);
    CHECK(holds(one[1].actual, "error 0.0e+00; written: time 9.00, error 5.0e-01"));
}
