#pragma once
// Reading the course's own files, to check rules about them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace source_text {

namespace fs = std::filesystem;

inline std::string read(const fs::path& path) {
    std::ifstream in{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}

// All files below a folder whose names end in one of these, sorted; none where the
// folder is missing.
inline std::vector<fs::path> files(const fs::path& folder,
                                   const std::vector<std::string>& extensions) {
    std::vector<fs::path> found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::recursive_directory_iterator{folder})
        if (std::find(extensions.begin(), extensions.end(), entry.path().extension()) !=
            extensions.end())
            found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

inline std::vector<fs::path> folders(const fs::path& folder) {
    std::vector<fs::path> found;
    if (!fs::exists(folder)) return found;
    for (const auto& entry : fs::directory_iterator{folder})
        if (entry.is_directory()) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

// What a pattern's first group matches, everywhere.
inline std::vector<std::string> matches(const std::string& text, const char* pattern) {
    const std::regex regex{pattern};
    std::vector<std::string> found;
    for (std::sregex_iterator it{text.begin(), text.end(), regex}, end; it != end; ++it)
        found.push_back((*it)[1]);
    return found;
}

}  // namespace source_text
