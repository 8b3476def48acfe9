#include <sys/utsname.h>

#include <companion/system/platform.hpp>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <rt/counted.hpp>
#include <thread>

namespace companion {

#ifdef __APPLE__
constexpr const char* library_path = "DYLD_LIBRARY_PATH=";
constexpr const char* library_end = ".dylib";
#else
constexpr const char* library_path = "LD_LIBRARY_PATH=";
constexpr const char* library_end = ".so";
#endif

std::string program_name(const std::string& name) {
    return name;
}

std::string library_name(const std::string& name) {
    return "lib" + name + library_end;
}

std::string libraries_in(const std::filesystem::path& folder) {
    return library_path + folder.string();
}

std::optional<std::int64_t> last_written(const std::filesystem::path& file) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(file, missing);
    if (missing) return {};
    return time.time_since_epoch().count();
}

void set_variable(const char* name, const char* value) {
    ::setenv(name, value, true);
}

std::vector<std::string> command_words(const std::string& line) {
    std::vector<std::string> words;
    std::string word;
    bool in_word = false;
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote == 0 && c == ' ') {
            if (in_word) words.push_back(word);
            in_word = false;
            word.clear();
            continue;
        }
        in_word = true;
        if (c == quote)
            quote = 0;
        else if (quote == 0 && (c == '"' || c == '\''))
            quote = c;
        else if (quote != '\'' && c == '\\' && i + 1 < line.size())
            word += line[++i];
        else
            word += c;
    }
    if (in_word) words.push_back(word);
    return words;
}

bool has_escapes(const char* terminal) {
    return terminal && std::strcmp(terminal, "dumb") != 0;
}

std::string instead_of_sanitizers() {
    return "";
}

std::string machine() {
    std::string name;
    std::ifstream in{"/proc/cpuinfo"};
    for (std::string line; name.empty() && std::getline(in, line);)
        if (line.rfind("model name", 0) == 0) name = line.substr(line.find(':') + 2);
    utsname system{};
    ::uname(&system);
    if (name.empty()) name = system.machine;
    return name + ", " + rt::counted(std::thread::hardware_concurrency(), "core") + ", " +
           system.sysname;
}

}  // namespace companion
