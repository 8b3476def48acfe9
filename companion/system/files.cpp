#include <algorithm>
#include <app/errors.hpp>
#include <app/files.hpp>
#include <companion/system/files.hpp>
#include <cstdint>
#include <cstdio>

namespace companion {

std::string why_no_file(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_regular_file(status)) return "";
    if (fs::is_directory(status)) return "is a folder, not a file";
    if (fs::exists(status)) return "is a pipe or a device, not a file";
    if (!fs::is_symlink(fs::symlink_status(path, error))) return "is missing";
    return "is a link to " + fs::read_symlink(path, error).string() + ", which is missing";
}

std::string read_file(const std::filesystem::path& path) {
    if (const std::string why = why_no_file(path); !why.empty())
        throw app::Failure("cannot read " + path.string() + ": it " + why);
    const auto bytes = app::read_bytes(path);
    if (!bytes) throw app::Failure("cannot read " + path.string());
    return *bytes;
}

std::string read_text(const std::filesystem::path& path) {
    std::string text = read_file(path);
    for (auto at = text.find("\r\n"); at != std::string::npos; at = text.find("\r\n", at))
        text.erase(at, 1);
    return text;
}

std::string text_if_there(const std::filesystem::path& path) {
    for (int left = 10; why_no_file(path).empty(); --left) try {
            return read_text(path);
        } catch (const app::Failure&) {
            if (left == 0) throw;
        }
    return "";
}

void copy_folder(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::filesystem::create_directories(to);
    for (const auto& entry : std::filesystem::directory_iterator{from}) {
        const auto copy = to / entry.path().filename();
        if (entry.is_directory())
            copy_folder(entry.path(), copy);
        else
            std::filesystem::copy_file(entry.path(), copy);
    }
}

std::vector<std::filesystem::path> source_files(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder, none}) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file(none) && name[0] != '.' && name[0] != '#' && name.back() != '~')
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string hash_of(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

}  // namespace companion
