#include <app/cores.hpp>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/commands/commands.hpp>
#include <companion/own/judge.hpp>
#include <companion/system/terminal.hpp>
#include <cstdio>

namespace companion {

int own_new(const Course& course, const std::string& folder) {
    const fs::path to = fs::absolute(folder);
    if (fs::exists(to) && !fs::is_empty(to))
        throw app::UsageError(folder + " is there and is not empty; name a new folder");
    fs::create_directories(to);
    fs::copy(course.root / "chapters/09_own/start", to, fs::copy_options::recursive);
    print("Your folder is " + to.string() + ". Read TASK.md in it, then write main.cpp.\n" +
          "./course own judge " + folder + " --rung 1 looks at the first rung.\n");
    return app::done;
}

int own_judge(const Course& course, const std::string& folder, int rung, std::uint64_t seed) {
    if (rung < 0 || rung > 9) throw app::UsageError("--rung: there are rungs 1 to 9");
    must_build(course, "09_own_solution");
    print("Scenes of seed " + std::to_string(seed) + (rung ? "" : "; this takes some minutes") +
          ".\n");
    int passed = 0, failed = 0;
    judge(
        {folder, course.program("09_own_solution"), seed, rung, app::physical_cores()},
        [&](const JudgedLine& line) {
            ++(line.passed ? passed : failed);
            const std::string first = (line.passed ? "+ " : "x ") + line.what + '\n';
            print((line.passed ? green(first) : red(first)) + wrapped(line.actual, "    ") + '\n');
            if (line.passed) return;
            print(wrapped("expected: " + line.expected, "    ") + '\n');
            if (!line.suggestion.empty()) print(wrapped(line.suggestion, "    ") + '\n');
        });
    print("\n" + std::to_string(passed) + " of " + std::to_string(passed + failed) +
          " lines pass. The same scenes again: --seed " + std::to_string(seed) + "\n");
    if (failed == 0 && rung > 0 && rung < 9)
        print("Next: --rung " + std::to_string(rung + 1) + '\n');
    if (failed == 0 && rung == 0) print(bold("You are the author of a ray tracer.\n"));
    return failed == 0 ? app::done : app::could_not;
}

}  // namespace companion
