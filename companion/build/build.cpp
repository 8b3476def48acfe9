#include <algorithm>
#include <app/errors.hpp>
#include <companion/build/build.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/build/stale.hpp>
#include <companion/build/turn.hpp>
#include <companion/model/state.hpp>
#include <companion/system/file_lock.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <thread>

namespace companion {
namespace {

constexpr std::size_t most_words = std::size_t{4} << 20;  // of a build's output

}  // namespace

BuildResult build(const Course& course, const std::vector<std::string>& targets) {
    const Turn turn{course};
    return build_in_turn(course, targets);
}

BuildResult build_in_turn(const Course& course, const std::vector<std::string>& targets) {
    const FileLock lock{private_folder(course) / "build.lock"};
    const std::vector<std::string> cmake{"cmake", "--build", course.build.string(), "--target"};
    std::vector<std::string> command = cmake;
    command.insert(command.end(), targets.begin(), targets.end());
    command.push_back("--");
    if (fs::exists(course.build / "build.ninja")) {
        command.insert(command.end(), {"-k", "0"});
    } else {
        // make builds one target at a time unless told otherwise, and does not configure anew for a
        // target that it does not know yet.
        command.insert(
            command.end(),
            {"-k", "-j" + std::to_string(std::max(1u, std::thread::hardware_concurrency()))});
        std::vector<std::string> configure = cmake;
        configure.push_back("cmake_check_build_system");
        run_process({.command = configure});
    }
    remove_stale(course);
    const Result result = run_process(
        {.command = command, .most_cpu = most_compiling, .most_memory = memory_of_compiler()});
    note_built(course);
    return {result.ok(), printable(result.output, most_words), result.cpu_seconds};
}

void must_build(const Course& course, const std::string& target) {
    const BuildResult result = build(course, {target});
    if (result.ok) return;
    const std::string error = first_error(course, result.output);
    throw app::Failure(error.empty() ? target + " cannot be built: " +
                                           result.output.substr(0, result.output.find('\n'))
                                     : error.substr(0, error.find('\n')));
}

}  // namespace companion
