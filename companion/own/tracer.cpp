#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/diagnostics.hpp>
#include <companion/build/side_build.hpp>
#include <companion/check/compiler_words.hpp>
#include <companion/model/route.hpp>
#include <companion/own/own_program.hpp>
#include <companion/own/tracer.hpp>
#include <companion/system/files.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <companion/system/terminal.hpp>
#include <csignal>
#include <cstdio>
#include <functional>
#include <regex>
#include <sstream>

namespace companion {
namespace {

constexpr std::size_t most_words = std::size_t{1} << 20;  // of the compiler's messages, in bytes

std::string compiler_name(const Course& course) {
    const std::string name = fs::path{cached(course, "CMAKE_CXX_COMPILER")}.filename().string();
    return name.empty() ? "c++" : name;
}

// The compiler's command without input and output; the preprocessor needs these words, too.
std::vector<std::string> compiler_words(const Course& course, const Chapter& last,
                                        bool follows = false) {
    std::vector<std::string> words{
        compiler_name(course), "-std=c++20", "-O3", "-pthread", "-Wall", "-Wshadow"};
    if (follows) words.push_back("-Icompanion/follow/recorder");
    words.push_back("-I" + course.relative(course.build / "yours"));
    for (const Chapter& chapter : grafts(course))
        if (chapter.name <= last.name)
            for (const fs::path& folder : given_folders(course, chapter))
                words.push_back("-I" + folder.generic_string());
    words.insert(words.end(), {"-Icommon", "exercises/tracer/tracer.cpp"});
    return words;
}

// The number of the later chapter whose header an error does not find; empty if there is none.
std::string chapter_of_header(const Course& course, const Chapter& last, const std::string& error) {
    std::smatch header;
    if (!std::regex_search(error, header, std::regex{"rt/(\\w+\\.hpp)'?(: No such| file not)"}))
        return "";
    for (const Chapter& chapter : grafts(course)) {
        if (chapter.name <= last.name) continue;
        std::vector<fs::path> folders = given_folders(course, chapter);
        folders.push_back(fs::path{"solutions"} / chapter.name);
        for (const fs::path& folder : folders)
            if (fs::exists(course.root / folder / "rt" / header[1].str())) return chapter.number();
    }
    return "";
}

// Runs a command that compiles this file alone. `reason` may know more about an error than its own
// words say.
void compile_alone(const Course& course, const std::vector<std::string>& command,
                   const fs::path& file,
                   const std::function<std::string(const std::string& error)>& reason) {
    const Result result = run_process({.command = command,
                                       .folder = course.root,
                                       .most_cpu = most_compiling,
                                       .most_memory = memory_of_compiler()});
    const std::string fails = file.filename().string() + " does not compile";
    if (result.ok()) {
        if (const std::string warning =
                first_warning(course, printable(result.output, most_words), {file});
            !warning.empty())
            std::fprintf(stderr, "The compiler warns: %s\n%s\n", warning.c_str(),
                         plain_words(warning).c_str());
        return;
    }
    const std::string error = first_error(course, printable(result.output, most_words), {file});
    if (error.empty()) throw app::Failure(fails + ": " + how_it_ended(result));
    std::string words = reason(error);
    if (words.empty()) words = plain_words(error);
    std::fprintf(stderr, "%s\n%s%s\n", error.c_str(),
                 words.empty() ? "" : "In plain words: ", words.c_str());
    throw app::Failure(fails);
}

const fs::path first_file = "exercises/00_toolchain/first.cpp";

}  // namespace

fs::path tracer_file(const Course& course) {
    return course.root / "exercises/tracer/tracer.cpp";
}

fs::path tracer_scene(const Course& course) {
    return course.root / "exercises/tracer/my.txt";
}

fs::path tracer_program(const Course& course, bool follows) {
    return course.build / program_name(follows ? "tracer_follow" : "tracer");
}

fs::path tracer_answer(const Course& course, const Chapter& chapter) {
    return course.root / "solutions/tracer" / (chapter.number() + ".cpp");
}

std::vector<Chapter> grafts(const Course& course) {
    std::vector<Chapter> all = chapters(course);
    std::erase_if(all, [](const Chapter& chapter) { return !chapter.graft; });
    return all;
}

NextGraft next_graft(const Course& course) {
    const State state = read_state(course);
    std::optional<Chapter> last;
    bool is_ready = true;
    for (const Step& step : route(course)) {
        if (step.exercise) {
            is_ready = is_ready && !is_open(course, state, step);
        } else if (is_open(course, state, step)) {
            if (is_ready || !last) return {step.chapter, true, step.chapter};
            return {step.chapter, false, *last};
        } else {
            last = step.chapter;
            is_ready = true;
        }
    }
    return {*last, true, *last};
}

std::vector<std::string> tracer_command(const Course& course, const Chapter& last, bool follows) {
    std::vector<std::string> words = compiler_words(course, last, follows);
    words.insert(words.end(), {"-o", course.relative(tracer_program(course, follows))});
    return words;
}

fs::path compile_first(const Course& course) {
    const fs::path program = course.build / program_name("first");
    compile_alone(course,
                  {compiler_name(course), "-std=c++20", "-O2", first_file.generic_string(), "-o",
                   course.relative(program)},
                  first_file, [](const std::string&) { return std::string{}; });
    return program;
}

void compile_tracer(const Course& course, const Chapter& last, bool follows) {
    compile_alone(course, tracer_command(course, last, follows),
                  course.relative(tracer_file(course)), [&](const std::string& error) {
                      const std::string later = chapter_of_header(course, last, error);
                      if (later.empty()) return std::string{};
                      return "Chapter " + later +
                             " has this header. Judge its graft once its exercises pass, or at "
                             "once: ./course tracer --graft " +
                             later;
                  });
}

std::vector<std::string> headers_of_tracer(const Course& course) {
    const std::vector<Chapter> all = grafts(course);
    std::vector<std::string> words = compiler_words(course, all.back());
    words.push_back("-MM");
    // A rule for make: the object, a colon, then the files that it depends on.
    std::istringstream rule{run_process({.command = words, .folder = course.root}).output};
    std::vector<std::string> headers;
    for (std::string word; rule >> word;)
        if (const fs::path file{word}; file.parent_path().filename() == "rt")
            headers.push_back(file.filename().string());
    return headers;
}

Drawn draw_by_tracer(const Course& course, const fs::path& program,
                     const std::vector<std::string>& words, const fs::path& picture,
                     double timeout) {
    std::error_code none;
    fs::remove(picture, none);
    std::vector<std::string> command{program.string()};
    command.insert(command.end(), words.begin(), words.end());
    const Result result = run_process({.command = command,
                                       .folder = course.root,
                                       .passes_signals = timeout == 0,
                                       .timeout = timeout,
                                       .most_file = most_picture,
                                       .most_output = most_picture});
    if (result.passed_on == SIGTERM) std::raise(SIGTERM);  // Ctrl-C ends the picture alone
    const std::string name = program.filename().string();
    if (!result.ok())
        throw app::Failure(
            name + ": " + how_it_ended(result) +
            (result.output.empty() || result.output[0] == 'P'
                 ? ""
                 : ": " + printable(result.output.substr(0, result.output.find('\n')), 300)));
    if (fs::exists(picture)) return {parse_ppm(read_file(picture)), printable(result.output)};
    if (result.output.empty()) throw app::Failure(name + " printed no picture and wrote none");
    app::replace_file(picture, result.output);
    return {parse_ppm(result.output), {}};
}

}  // namespace companion
