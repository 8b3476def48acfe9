#include <unistd.h>
#include <app/errors.hpp>
#include <atomic>
#include <companion/own/own_program.hpp>
#include <companion/system/files.hpp>
#include <fstream>

namespace companion {
namespace {

fs::path new_folder() {
    static std::atomic<int> count = 0;
    const fs::path folder = fs::temp_directory_path() /
                            ("own-" + std::to_string(getpid()) + '-' + std::to_string(count++));
    fs::create_directories(folder);
    return folder;
}

}  // namespace

OwnProgram::OwnProgram(const fs::path& folder, const std::vector<std::string>& options)
    : work_{new_folder()}, program_{work_ / "copy/own"} {
    if (!fs::exists(folder / "build.sh"))
        throw app::Failure("there is no build.sh in " + folder.string() +
                           "; ./course own new FOLDER makes a folder that has one");
    fs::copy(folder, work_ / "copy", fs::copy_options::recursive);
    std::error_code ignored;
    fs::remove(program_, ignored);
    std::vector<std::string> command{"sh", "build.sh"};
    command.insert(command.end(), options.begin(), options.end());
    const Result built =
        run_process({.command = command, .folder = work_ / "copy", .timeout = 300});
    if (!built.ok()) throw app::Failure("build.sh: " + how_it_ended(built) + '\n' + built.output);
    if (!fs::exists(program_))
        throw app::Failure("build.sh ran and made no program named own, which was expected");
}

OwnProgram::OwnProgram(fs::path program, Existing)
    : work_{new_folder()}, program_{std::move(program)} {}

OwnProgram::~OwnProgram() {
    std::error_code ignored;
    fs::remove_all(work_, ignored);
}

OwnProgram::Drawn OwnProgram::draw(const std::string& scene,
                                   const std::vector<std::string>& options, double timeout) const {
    static std::atomic<int> count = 0;
    const std::string number = std::to_string(count++);
    const fs::path scene_file = work_ / (number + ".txt"), picture = work_ / (number + ".ppm");
    std::ofstream{scene_file} << scene;
    std::vector<std::string> command{program_, scene_file, picture};
    command.insert(command.end(), options.begin(), options.end());
    Drawn drawn;
    drawn.result = run_process({.command = command, .timeout = timeout, .most_output = 1 << 20});
    if (drawn.result.ok()) {
        if (!fs::exists(picture))
            throw app::Failure("own ended with 0 and wrote no picture, which was expected");
        drawn.bytes = read_file(picture);
        drawn.picture = parse_ppm(drawn.bytes);
    }
    std::error_code ignored;
    fs::remove(scene_file, ignored);
    fs::remove(picture, ignored);
    return drawn;
}

}  // namespace companion
