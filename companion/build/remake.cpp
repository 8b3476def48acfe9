#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/build/remake.hpp>
#include <companion/system/files.hpp>
#include <companion/system/platform.hpp>
#include <companion/system/process.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

namespace companion {
namespace {

// The compiler's words without the input, the output and the request for an object file. A known
// mistake may cause warnings and must still run, so -Werror is dropped. It runs only for a second
// or two: compiling with -O3 would take longer than that saves.
std::vector<std::string> without_files(const std::vector<std::string>& words) {
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "-o" || words[i] == "-c")
            ++i;
        else if (words[i] != "-Werror")
            kept.push_back(words[i] == "-O3" ? "-O1" : words[i]);
    }
    return kept;
}

// The words that the linker needs, too; it does not need the headers that are included first.
std::vector<std::string> for_linking(const std::vector<std::string>& words) {
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "-include")
            ++i;
        else if (words[i] != "-Winvalid-pch")
            kept.push_back(words[i]);
    }
    return kept;
}

}  // namespace

Remake::Remake(const Course& course, const std::string& target) {
    const fs::path file = course.build / "compile_commands.json";
    for (const auto& entry : nlohmann::json::parse(read_file(file))) {
        const auto command = entry.at("command").get<std::string>();
        std::string slashes = command;  // on Windows CMake writes backslashes
        std::replace(slashes.begin(), slashes.end(), '\\', '/');
        if (slashes.find("/" + target + ".dir/") == std::string::npos) continue;
        folder_ = entry.at("directory").get<std::string>();
        sources_.push_back(
            {entry.at("file").get<std::string>(), without_files(command_words(command))});
    }
    if (sources_.empty()) throw app::Failure(file.string() + " has no target " + target);
    std::istringstream lines{read_text(course.build / "link" / (target + ".txt"))};
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) linked_.push_back(line);
}

BuildResult Remake::operator()(const fs::path& first, const fs::path& result) const {
    app::make_folder(result.parent_path());
    BuildResult done{true, {}};
    const auto run = [&](const std::vector<std::string>& command) {
        const Result ran = run_process({.command = command, .folder = folder_});
        done.ok = done.ok && ran.ok();
        done.output += ran.output;
    };
    std::vector<std::string> link = for_linking(sources_.front().words);
    for (const Source& source : sources_) {
        std::vector<std::string> words = source.words;
        words.insert(words.begin() + 1, "-I" + first.string());
        fs::path file = source.file;
        for (const fs::path& other : {first / "rt" / file.filename(), first / file.filename()})
            if (fs::exists(other)) file = other;
        const std::string object = result.string() + '.' + file.filename().string() + ".o";
        words.insert(words.end(), {"-c", file.string(), "-o", object});
        run(words);
        link.push_back(object);
    }
    link.insert(link.end(), linked_.begin(), linked_.end());
    link.insert(link.end(), {"-o", result.string()});
    if (done.ok) run(link);
    return done;
}

}  // namespace companion
