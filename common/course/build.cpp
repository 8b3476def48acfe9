#include <algorithm>
#include <app/errors.hpp>
#include <course/build.hpp>
#include <course/file_lock.hpp>
#include <course/process.hpp>
#include <course/state.hpp>
#include <sstream>
#include <string_view>
#include <thread>

namespace course {
namespace {

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// A path of the course as a person of the course knows it.
std::string relative(const Course& course, std::string line) {
    for (const fs::path& folder : {course.root, fs::weakly_canonical(course.root)}) {
        const std::string prefix = folder.string() + '/';
        for (auto at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
            line.erase(at, prefix.size());
    }
    // The build runs in its own folder; compilers may name files relative to that.
    if (line.rfind("../", 0) == 0) line.erase(0, 3);
    return line;
}

}  // namespace

BuildResult build(const Course& course, const std::vector<std::string>& targets) {
    const FileLock lock{private_folder(course) / "build.lock"};
    std::vector<std::string> command{"cmake", "--build", course.build.string(), "--target"};
    command.insert(command.end(), targets.begin(), targets.end());
    command.push_back("--");
    if (fs::exists(course.build / "build.ninja"))
        command.insert(command.end(), {"-k", "0"});
    else  // make, which builds one thing at a time where it is not told otherwise
        command.insert(
            command.end(),
            {"-k", "-j" + std::to_string(std::max(1u, std::thread::hardware_concurrency()))});
    const Result result = run_process({.command = command});
    return {result.ok(), result.output};
}

void must_build(const Course& course, const std::string& target) {
    const BuildResult result = build(course, {target});
    if (result.ok) return;
    const std::string error = first_error(course, result.output);
    throw app::Failure(error.empty() ? target + " cannot be built: " +
                                           result.output.substr(0, result.output.find('\n'))
                                     : error.substr(0, error.find('\n')));
}

std::string first_error(const Course& course, const std::string& output) {
    std::istringstream in{output};
    std::string linker;
    for (std::string line; std::getline(in, line);) {
        // "file:line:column: error: what" of a compiler, and the line of source that it shows
        if (has(line, ": error: ") || has(line, ": fatal error: ")) {
            std::string error = relative(course, line);
            for (int i = 0; i < 2 && std::getline(in, line) && line.rfind(' ', 0) == 0; ++i)
                error += '\n' + line;
            return error;
        }
        if (linker.empty() &&
            (has(line, "undefined reference to ") || has(line, "multiple definition of ") ||
             has(line, "Undefined symbol")))
            linker = "the linker says: " + line.substr(line.find_first_of("uUm", line.rfind(": ")));
    }
    return linker;
}

}  // namespace course
