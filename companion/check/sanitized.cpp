#include <app/files.hpp>
#include <companion/build/build.hpp>
#include <companion/build/side_build.hpp>
#include <companion/check/check.hpp>
#include <companion/check/sanitized.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <sstream>

namespace companion {

SanitizerReport read_sanitizer_report(const std::string& output,
                                      const std::vector<fs::path>& files) {
    SanitizerReport report;
    std::istringstream in{output};
    for (std::string line; std::getline(in, line);) {
        line = printable(line);
        if (report.what.empty())
            for (const std::string mark : {"ERROR: AddressSanitizer: ", "ERROR: ThreadSanitizer: ",
                                           "WARNING: ThreadSanitizer: ", "runtime error: "})
                if (const auto at = line.find(mark); at != std::string::npos)
                    report.what = line.substr(at + mark.size());
        if (report.what.rfind("ABRT ", 0) == 0)
            report.what =
                "the program was aborted by an exception, by a thread or by a check of a library";
        if (report.what.empty()) continue;
        for (const fs::path& file : files) {
            // Sanitizers name files as the compiler did: with a path from the root of the disk, or
            // from the build folder.
            const std::string path = '/' + file.string() + ':';
            const auto at = line.find(path);
            if (at == std::string::npos) continue;
            const auto number = at + path.size();
            const auto end = line.find_first_not_of("0123456789", number);
            report.where = file.string() + ':' + line.substr(number, end - number);
            return report;
        }
    }
    return report;
}

std::string to_text(const SanitizerReport& report) {
    return report.what + (report.where.empty() ? "" : " at " + report.where);
}

std::vector<std::string> at_fixed_addresses() {
    if (is_installed("setarch") && run_process({.command = {"setarch", "-R", "true"}}).ok())
        return {"setarch", "-R"};
    return {};
}

SanitizedRun run_sanitized(const Course& course, const Exercise& exercise, bool threads) {
    const Course side =
        side_build(course, threads ? "sanitized-threads" : "sanitized",
                   {"-DCMAKE_BUILD_TYPE=Debug",
                    std::string{"-DRT_SANITIZE="} + (threads ? "thread" : "address,undefined")});
    if (!fs::exists(side.build / "check"))
        print("The first time, building takes about a minute.\n");
    for (const char* const target : {"check.", "yours."}) must_build(side, target + exercise.id);
    const fs::path log = side.build / (exercise.id + ".txt");
    // The core runs first: a simple answer leaves stars open, and there it is allowed to overflow.
    std::string said;
    for (const bool stars : {false, true}) {
        std::vector<std::string> command =
            threads ? at_fixed_addresses() : std::vector<std::string>{};
        // If the crash is in a library, the learner's line is further up in the stack trace.
        command.insert(command.end(),
                       {"env", "UBSAN_OPTIONS=print_stacktrace=1", "ASAN_OPTIONS=handle_abort=2",
                        "TSAN_OPTIONS=handle_abort=2"});
        for (std::string& word : command_of(
                 side,
                 {.exercise = exercise.id, .part = stars ? Cases::Part::stars : Cases::Part::core}))
            command.push_back(std::move(word));
        const Result result = run_process({.command = command, .timeout = 10 * course.patience});
        app::replace_file(log, result.output);
        const SanitizerReport report = read_sanitizer_report(result.output, exercise.files);
        const std::string start = stars ? "Its stars: the " : "The core: the ";
        if (!report.what.empty())
            said += start + red("sanitizer reports: ") + report.what + '\n' +
                    (report.where.empty() ? "" : "  at " + bold(report.where) + '\n') +
                    "  The full report: " + course.relative(log) + '\n';
        else
            said += start + "sanitizers report nothing; " +
                    (result.ok()          ? "all test cases pass"
                     : result.signal == 0 ? "some test cases fail"
                                          : "the test cases ended with " + how_it_ended(result)) +
                    ".\n";
        if (!stars && (!result.ok() || !report.what.empty())) return {false, said};
    }
    return {true, said};
}

}  // namespace companion
