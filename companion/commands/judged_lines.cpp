#include <app/cores.hpp>
#include <app/platform.hpp>
#include <companion/build/build.hpp>
#include <companion/commands/judged_lines.hpp>
#include <companion/model/state.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/terminal.hpp>
#include <ctime>
#include <random>

namespace companion {

JudgedLines::JudgedLines() : on_terminal_{app::is_terminal(stdout)} {
    if (on_terminal_) begins = [](const std::string& what) { print(dim("  " + what + " ...")); };
}

void JudgedLines::operator()(const JudgedLine& line) {
    ++lines;
    passed += line.passed;
    if (on_terminal_) print("\r\033[K");
    const std::string first = (line.passed ? "+ " : "x ") + line.what + '\n';
    print((line.passed ? green(first) : red(first)) + wrapped(line.actual, "    ") + '\n');
    if (line.passed) return;
    print(wrapped("expected: " + line.expected, "    ") + '\n');
    if (!line.suggestion.empty()) print(wrapped(line.suggestion, "    ") + '\n');
}

bool judge_own(const Course& course, const fs::path& folder, std::uint64_t seed,
               const std::string& part, JudgedLines& lines) {
    must_build(course, "09_own_solution");
    // The hash of the sources that are judged, even if they are edited meanwhile.
    const std::string hash = fs::exists(folder / "build.sh") ? hash_of_own(folder) : "";
    JudgeRequest request{folder, course.program("09_own_solution"), seed, part,
                         app::physical_cores()};
    request.begins = lines.begins;
    bool core = true;
    judge(request, [&](const JudgedLine& line) {
        lines(line);
        // If build.sh fails, there are no other lines.
        if (is_core(line) || line.what == "build.sh") core = core && line.passed;
    });
    if (part.empty())
        change_state(course, [&](State& state) {
            const bool first = core && state.own.first_passed == 0;
            state.own = {folder.string(),
                         hash,
                         lines.lines,
                         lines.passed,
                         first ? std::time(nullptr) : state.own.first_passed,
                         core};
        });
    return core;
}

std::uint64_t scenes_seed(const Given& given) {
    const std::uint64_t wanted = given.number("--seed");
    return wanted ? wanted : 1 + std::random_device{}() % 9999;
}

}  // namespace companion
