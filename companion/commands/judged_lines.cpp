#include <app/cores.hpp>
#include <app/files.hpp>
#include <app/platform.hpp>
#include <cctype>
#include <companion/build/build.hpp>
#include <companion/commands/judged_lines.hpp>
#include <companion/compare/comparison_sheet.hpp>
#include <companion/model/state.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/terminal.hpp>
#include <ctime>
#include <random>
#include <rt/image_file.hpp>

namespace companion {
namespace {

// "step 9: --list draws the same bytes" as "step_9_list_draws_the_same_bytes".
std::string folder_of(const std::string& line) {
    std::string name;
    for (const char c : line)
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += c;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    return name;
}

}  // namespace

JudgedLines::JudgedLines(const Course& course, std::string program)
    : course_{course}, program_{std::move(program)}, on_terminal_{app::is_terminal(stdout)} {
    std::error_code held;  // a viewer may hold a picture
    fs::remove_all(course_.out() / "judge", held);
    if (program_.find(' ') != std::string::npos) program_ = '"' + program_ + '"';
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
    keep(line);
}

void JudgedLines::keep(const JudgedLine& line) const {
    const Looked& looked = line.looked;
    const fs::path folder = course_.out() / "judge" / folder_of(line.what);
    const std::string name = course_.relative(folder);
    if (looked.scene.empty() && !looked.pictures) return;
    app::make_folder(folder);
    if (looked.pictures) {
        const auto put = [&](const char* file, const rt::Image& image) {
            app::replace_file(folder / file, rt::encode_png(image));
        };
        put("yours.png", mean_of({looked.pictures->mine.back()}));
        put("ours.png", mean_of({looked.pictures->solution.back()}));
        put("beside.png", comparison_sheet(*looked.pictures));
        print("    Yours beside ours: " + name + "/beside.png\n");
    }
    std::string command = program_;
    if (!looked.scene.empty()) {
        app::replace_file(folder / "scene.txt", looked.scene);
        command += ' ' + name + "/scene.txt " + name + "/again.ppm";
    }
    if (!looked.mesh.empty()) app::replace_file(folder / "shape.obj", looked.mesh);
    for (const std::string& word : looked.words) command += ' ' + word;
    if (looked.scene.empty()) command += " > " + name + "/again.ppm";
    print("    Draw it again:     " + command + "\n\n");
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
            state.own = {folder.generic_string(),
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
