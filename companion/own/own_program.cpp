#include <app/errors.hpp>
#include <atomic>
#include <companion/build/diagnostics.hpp>
#include <companion/own/own_program.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/files.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/terminal.hpp>
#include <fstream>

namespace companion {
namespace {

constexpr std::size_t most_said = 300;  // bytes of the program's output that fit into a line

std::string first_line(const std::string& said) {
    return printable(said.substr(0, said.find('\n')), most_said);
}

// A name for the copy of a folder. Throws app::Failure if the folder cannot be built.
std::string name_of_copy(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw app::Failure("there is no folder " + folder.string() +
                           "; ./course own new FOLDER makes one");
    if (!fs::exists(folder / "build.sh"))
        throw app::Failure("there is no build.sh in " + folder.string() +
                           "; ./course own new FOLDER makes a folder that has one");
    if (read_file(folder / "build.sh").find("\r\n") != std::string::npos)
        throw app::Failure(
            "build.sh has the line ends of Windows, which sh takes for parts of words: save it "
            "with the line ends LF");
    return "own";
}

// The first error of a compiler or linker in the folder, in one line.
std::string first_error_in(const fs::path& folder, const std::string& output) {
    if (output.find("undefined reference to `main'") != std::string::npos ||
        output.find("undefined reference to `WinMain") != std::string::npos ||
        output.find("_main") != std::string::npos)
        return "there is no main() yet; TASK.md says what to write";
    const std::string error = first_error({folder, folder}, output);
    return first_line(error.empty() ? output : error);
}

}  // namespace

OwnProgram::OwnProgram(const fs::path& folder, const std::vector<std::string>& options)
    : scratch_{name_of_copy(folder)},
      work_{scratch_.path()},
      program_{work_ / "copy" / program_name("own")} {
    for (const fs::path& source : own_sources(folder)) {
        fs::create_directories((work_ / "copy" / source).parent_path());
        fs::copy_file(folder / source, work_ / "copy" / source);
    }
    // Temporary files go next to the copy: if the compiler is interrupted, they are removed
    // together.
    std::vector<std::string> command{"env", "TMPDIR=" + work_.string(), "sh", "build.sh"};
    command.insert(command.end(), options.begin(), options.end());
    const Result built = run_process({.command = command,
                                      .folder = work_ / "copy",
                                      .timeout = most_compiling,
                                      .most_memory = memory_of_compiler()});
    if (!built.ok())
        throw app::Failure(
            "build.sh: " + how_it_ended(built) +
            (built.output.empty() ? "" : ": " + first_error_in(work_ / "copy", built.output)));
    if (!fs::exists(program_))
        throw app::Failure("build.sh ran but did not make a program named own");
}

OwnProgram::OwnProgram(Existing, const fs::path& program)
    : scratch_{"own"}, work_{scratch_.path()}, program_{fs::absolute(program)} {}

Result OwnProgram::call(const std::vector<std::string>& words, Output output) const {
    std::vector<std::string> command = before;
    command.push_back(program_.string());
    command.insert(command.end(), words.begin(), words.end());
    const Result result = run_process({.command = command,
                                       .folder = work_,
                                       .output = output,
                                       .may_start_others = may_start_others,
                                       .timeout = patience,
                                       .most_file = most_picture,
                                       .most_output = 1 << 20});
    times_out_ += result.timed_out;
    return result;
}

OwnProgram::Drawn OwnProgram::draw(const std::string& scene,
                                   const std::vector<std::string>& options, const std::string& mesh,
                                   const HowCalled& how) const {
    static std::atomic<int> count = 0;
    const std::string number = std::to_string(count++);
    // The names are short and relative: on Windows, a program may not be able to read the letters
    // of a whole path. The scene has a folder of its own, so a mesh beside it is not in the folder
    // in which the program runs.
    const fs::path folder = work_ / number, picture = work_ / (number + ".ppm");
    fs::create_directories(folder);
    std::ofstream{folder / "scene.txt", std::ios::binary} << scene;
    if (!mesh.empty()) std::ofstream{folder / "shape.obj", std::ios::binary} << mesh;
    std::vector<std::string> words{number + "/scene.txt", number + ".ppm"};
    words.insert(how.options_first ? words.begin() : words.end(), options.begin(), options.end());
    Drawn drawn{call(words, how.output), {}, {}};
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    if (drawn.result.ok()) {
        if (!fs::exists(picture))
            throw app::Failure(program_.filename() == program_name("tracer")
                                   ? "your tracer ended with exit code 0 but wrote no picture"
                                   : "the program own ended with exit code 0 but wrote no picture "
                                     "to its second file");
        drawn.bytes = read_file(picture);
        drawn.picture = parse_ppm(drawn.bytes);
    }
    fs::remove(picture, ignored);
    return drawn;
}

OwnProgram::Drawn OwnProgram::picture(const std::string& scene,
                                      const std::vector<std::string>& options,
                                      const std::string& mesh, const HowCalled& how) const {
    Drawn drawn = draw(scene, options, mesh, how);
    const std::string& said = drawn.result.output;
    if (!drawn.result.ok())
        throw app::Failure(program_.filename().string() + ": " + how_it_ended(drawn.result) +
                           (said.empty() ? "" : ": " + first_line(said)));
    return drawn;
}

}  // namespace companion
