#include <algorithm>
#include <app/errors.hpp>
#include <companion/own/standing.hpp>
#include <companion/system/files.hpp>
#include <set>

namespace companion {
namespace {

constexpr int most_entries = 10'000;              // of a folder
constexpr std::uintmax_t most_in_file = 1 << 20;  // bytes
constexpr std::uintmax_t most_in_all = 64 * most_in_file;

// Whether a file has the name of a picture or of the program, or is too large.
bool is_left_out(const fs::path& file) {
    static const std::set<fs::path> pictures{".ppm", ".png", ".jpg"};
    std::error_code gone;
    return file.filename() == "own" || pictures.count(file.extension()) ||
           fs::file_size(file, gone) > most_in_file || gone;
}

bool is_source(const fs::path& file) {
    static const std::set<fs::path> endings{".c", ".cc", ".cpp", ".cxx", ".h", ".hpp", ".sh"};
    return fs::is_regular_file(file) && endings.count(file.extension());
}

}  // namespace

std::vector<fs::path> own_sources(const fs::path& folder) {
    std::vector<fs::path> sources;
    int entries = 0;
    std::uintmax_t bytes = 0;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it{folder, options}, end; it != end; ++it) {
        if (++entries > most_entries || bytes > most_in_all)
            throw app::Failure(folder.string() +
                               " holds too much for one program: name the folder that ./course own "
                               "new made");
        const std::string name = it->path().filename().string();
        const bool left_out = name[0] == '.' || (it->is_directory() && name == "build");
        if (left_out && it->is_directory()) it.disable_recursion_pending();
        if (left_out && is_source(it->path()) &&
            !fs::exists(it->path().parent_path() / name.substr(1)))
            throw app::Failure(name + " is hidden, and hidden files are left out: name it " +
                               name.substr(1));
        if (left_out || !it->is_regular_file() || is_left_out(it->path())) continue;
        const std::string text = read_file(it->path());
        bytes += text.size();
        if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
            throw app::Failure(name +
                               " is in UTF-16, which compilers do not read: save it as UTF-8");
        if (text.find('\0') == std::string::npos)
            sources.push_back(it->path().lexically_relative(folder));
    }
    std::sort(sources.begin(), sources.end());
    return sources;
}

std::string hash_of_own(const fs::path& folder) try {
    if (!fs::is_directory(folder)) return "";
    std::string bytes;
    for (const fs::path& file : own_sources(folder))
        bytes += file.string() + '\n' + read_file(folder / file) + '\0';
    return hash_of(bytes);
} catch (const app::Failure&) {
    return "";
}

bool is_core(const JudgedLine& line) {
    for (const char step : {'1', '2', '3', '4', '5', '6'})
        if (line.what.rfind(std::string{"step "} + step + ':', 0) == 0) return true;
    return false;
}

bool own_passes(const OwnRecord& own) {
    return own.core && !own.hash.empty() && own.hash == hash_of_own(own.folder);
}

bool own_stars_pass(const OwnRecord& own) {
    return own_passes(own) && own.passed == own.lines;
}

std::string standing_of(const OwnRecord& own) {
    if (own.lines == 0 || own.hash.empty()) return "not judged yet";
    if (own.hash != hash_of_own(own.folder)) return "changed since it was judged";
    if (own.passed == own.lines) return "your own ray tracer passes";
    const std::string core = own.core ? "core passes, " : "";
    return core + std::to_string(own.passed) + " of " + std::to_string(own.lines) + " lines pass";
}

}  // namespace companion
