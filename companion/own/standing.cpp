#include <algorithm>
#include <companion/own/standing.hpp>
#include <companion/system/files.hpp>
#include <set>

namespace companion {
namespace {

bool is_source(const fs::path& file) {
    static const std::set<fs::path> pictures{".ppm", ".png", ".jpg"};
    return file.filename() != "own" && !pictures.count(file.extension()) &&
           read_file(file).find('\0') == std::string::npos;
}

}  // namespace

std::vector<fs::path> own_sources(const fs::path& folder) {
    std::vector<fs::path> sources;
    for (fs::recursive_directory_iterator it{folder}, end; it != end; ++it) {
        const std::string name = it->path().filename().string();
        const bool left_out = name[0] == '.' || (it->is_directory() && name == "build");
        if (left_out && it->is_directory()) it.disable_recursion_pending();
        if (!left_out && it->is_regular_file() && is_source(it->path()))
            sources.push_back(it->path().lexically_relative(folder));
    }
    std::sort(sources.begin(), sources.end());
    return sources;
}

std::string hash_of_own(const fs::path& folder) {
    if (!fs::is_directory(folder)) return "";
    std::string bytes;
    for (const fs::path& file : own_sources(folder))
        bytes += file.string() + '\n' + read_file(folder / file) + '\0';
    return hash_of(bytes);
}

bool is_core(const JudgedLine& line) {
    for (const char rung : {'1', '2', '3', '4', '5', '6'})
        if (line.what.rfind(std::string{"rung "} + rung + ':', 0) == 0) return true;
    return false;
}

bool own_passes(const OwnRecord& own) {
    return own.core && own.hash == hash_of_own(own.folder);
}

bool own_stars_pass(const OwnRecord& own) {
    return own_passes(own) && own.passed == own.lines;
}

std::string standing_of(const OwnRecord& own) {
    if (own.lines == 0) return "not judged yet";
    if (own.hash != hash_of_own(own.folder)) return "changed since it was judged";
    if (own.passed == own.lines) return "your own ray tracer passes";
    const std::string core = own.core ? "core passes, " : "";
    return core + std::to_string(own.passed) + " of " + std::to_string(own.lines) + " lines pass";
}

}  // namespace companion
