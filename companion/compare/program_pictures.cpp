#include <app/json.hpp>
#include <atomic>
#include <cmath>
#include <companion/compare/program_pictures.hpp>
#include <companion/system/files.hpp>
#include <companion/system/scratch_folder.hpp>
#include <companion/system/terminal.hpp>
#include <cstdlib>
#include <sstream>

namespace companion {
namespace {

namespace fs = std::filesystem;

constexpr double patience = 20, patience_when_busy = 60;  // seconds for a picture
constexpr double many_pixels = 36'864;                    // 256 x 144
constexpr int few_samples = 9;                            // 3 x 3 cells, so that jitter matters
constexpr int few_bounces = 5;  // so that the ending of a path at its limit is visible

std::string last_line(const std::string& text) {
    const auto end = text.find_last_not_of('\n');
    if (end == std::string::npos) return {};
    const auto start = text.rfind('\n', end);
    return text.substr(start == std::string::npos ? 0 : start + 1,
                       end - (start == std::string::npos ? 0 : start + 1) + 1);
}

Result run_for(const std::vector<std::string>& command, double most_cpu = 0) {
    const Result result = run_process({.command = command,
                                       .timeout = most_cpu > 0 ? patience_when_busy : patience,
                                       .most_cpu = most_cpu});
    if (result.ok()) return result;
    const std::string name = fs::path{command[0]}.filename().string();
    const bool explained = result.signal == 0 && !result.timed_out && !result.output.empty();
    throw DrawingFailed(
        explained ? printable(last_line(result.output)) : name + ": " + how_it_ended(result),
        result);
}

}  // namespace

DrawingOptions options_from(const std::string& description) {
    const auto defaults = app::texts_in(description, "--describe");
    const auto number = [&](const char* name) {
        return defaults.count(name) ? std::atoi(defaults.at(name).c_str()) : 0;
    };
    DrawingOptions options{number("width"), number("height"), number("spp"), number("depth"),
                           defaults.count("seed") == 1};
    std::istringstream shows{defaults.count("show") ? defaults.at("show") : ""};
    for (std::string word; shows >> word;) options.shows.push_back(word);
    return options;
}

DrawingOptions for_comparison(DrawingOptions options) {
    if (!options.has_seed) return options;
    const double scale =
        std::sqrt(many_pixels / (static_cast<double>(options.width) * options.height));
    if (scale < 1) {
        options.width = static_cast<int>(std::lround(options.width * scale));
        options.height = static_cast<int>(std::lround(options.height * scale));
    }
    options.spp = std::min(options.spp, few_samples);
    options.depth = std::min(options.depth, few_bounces);
    return options;
}

std::vector<std::string> words_for(const DrawingOptions& options, std::uint64_t seed) {
    std::vector<std::string> words;
    const auto add = [&](const char* name, std::uint64_t value) {
        words.insert(words.end(), {name, std::to_string(value)});
    };
    if (options.width > 0) add("--width", static_cast<std::uint64_t>(options.width));
    if (options.height > 0) add("--height", static_cast<std::uint64_t>(options.height));
    if (options.spp > 0) add("--spp", static_cast<std::uint64_t>(options.spp));
    if (options.depth > 0) add("--depth", static_cast<std::uint64_t>(options.depth));
    if (options.has_seed) add("--seed", seed);
    if (!options.show.empty()) words.insert(words.end(), {"--show", options.show});
    return words;
}

Picture draw_with(const fs::path& program, const DrawingOptions& options, std::uint64_t seed,
                  double most_cpu, double* cpu_seconds) {
    static std::atomic<int> count = 0;
    static const ScratchFolder scratch{"course-compare"};
    const fs::path file = scratch.path() / (std::to_string(++count) + ".ppm");
    std::vector<std::string> command{program.string(), "--quiet", "--out", file.string()};
    for (std::string& word : words_for(options, seed)) command.push_back(std::move(word));
    const Result result = run_for(command, most_cpu);
    if (cpu_seconds) *cpu_seconds += result.cpu_seconds;
    const std::string picture = read_file(file);
    fs::remove(file);
    return parse_ppm(picture);
}

DrawingOptions options_of(const fs::path& program) {
    return options_from(run_for({program.string(), "--describe"}).output);
}

TwoPrograms two_programs(const fs::path& mine, const fs::path& solution) {
    const DrawingOptions options = for_comparison(options_of(solution));
    const auto draw = [options](const fs::path& program) {
        return [=](std::uint64_t seed) { return draw_with(program, options, seed); };
    };
    return {draw(mine), draw(solution), options.has_seed};
}

}  // namespace companion
