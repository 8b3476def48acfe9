// The error rates of `course compare`, measured.
//
//   compare_programs differ MINE SOLUTION        exit 0 when the two programs' pictures differ
//   compare_programs alarms RUNS PROGRAM...      compares each program with itself, RUNS times
//                                                with new seeds; exit 0 when at most one run in
//                                                300 says that it differs
#include <chrono>
#include <companion/compare/program_pictures.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using Clock = std::chrono::steady_clock;

// On a busy machine a program may be stopped for being slow: then this tries again.
companion::Comparison patiently(const companion::TwoPrograms& pair, std::uint64_t start = 1) {
    for (int i = 0; i < 5; ++i) try {
            return companion::compare(pair, start);
        } catch (const companion::DrawingFailed& failed) {
            if (!failed.result.timed_out) throw;
        }
    return companion::compare(pair, start);
}

int differ(const char* mine, const char* solution) {
    const auto start = Clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    try {
        const auto found = patiently(companion::two_programs(mine, solution));
        std::printf("%s, %.1f s\n", found.same ? "THE SAME" : "different", seconds());
        for (const std::string& line : found.words()) std::printf("  %s\n", line.c_str());
        return found.same ? 1 : 0;
    } catch (const companion::DrawingFailed& failed) {
        const bool started = failed.result.exit_code != 127 && failed.result.exit_code != 2;
        std::printf("%s: %s, %.1f s\n", started ? "different" : "FAILED", failed.what(), seconds());
        return started ? 0 : 1;
    }
}

int alarms(int runs, int count, char** programs) {
    int all = 0;
    for (int i = 0; i < count; ++i) {
        companion::TwoPrograms pair = companion::two_programs(programs[i], programs[i]);
        int alarms = 0, second_steps = 0;
        const auto start = Clock::now();
        for (int run = 0; run < runs; ++run) {
            // Other seeds for the second program's first pictures: equal code must not pass merely
            // because its bits are equal.
            auto fair = pair;
            fair.solution = [&](std::uint64_t seed) { return pair.solution(seed ^ 0x5555); };
            const auto found = patiently(fair, static_cast<std::uint64_t>(1000 + run));
            alarms += !found.same;
            second_steps += found.pictures > 8;
            if (!found.same)
                for (const std::string& line : found.words())
                    std::printf("  run %d: %s\n", run, line.c_str());
        }
        const std::chrono::duration<double> time = Clock::now() - start;
        std::printf("%s: %d false alarms in %d runs, %d with a second step, %.2f s a run\n",
                    programs[i], alarms, runs, second_steps, time.count() / runs);
        std::fflush(stdout);
        all += alarms;
    }
    return all * 300 > std::max(300, runs * count);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::strcmp(argv[1], "differ") == 0) return differ(argv[2], argv[3]);
    if (argc > 3 && std::strcmp(argv[1], "alarms") == 0 && std::atoi(argv[2]) > 0)
        return alarms(std::atoi(argv[2]), argc - 3, argv + 3);
    std::fprintf(stderr, "usage: compare_programs differ MINE SOLUTION | alarms RUNS PROGRAM...\n");
    return 2;
}
