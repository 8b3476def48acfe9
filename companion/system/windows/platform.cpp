#include <windows.h>

#include <shellapi.h>

#include <companion/system/platform.hpp>
#include <companion/system/windows/wide.hpp>
#include <cstdlib>
#include <cstring>
#include <rt/counted.hpp>
#include <system_error>
#include <thread>

namespace companion {

std::wstring wide(const std::string& text) {
    const int size = static_cast<int>(text.size());
    std::wstring all(
        static_cast<std::size_t>(::MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)),
        L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, text.data(), size, all.data(), static_cast<int>(all.size()));
    return all;
}

std::string narrow(const std::wstring& text) {
    const int size = static_cast<int>(text.size());
    std::string all(static_cast<std::size_t>(::WideCharToMultiByte(CP_UTF8, 0, text.data(), size,
                                                                   nullptr, 0, nullptr, nullptr)),
                    '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text.data(), size, all.data(), static_cast<int>(all.size()),
                          nullptr, nullptr);
    return all;
}

std::string last_error() {
    return std::system_category().message(static_cast<int>(::GetLastError()));
}

std::string program_name(const std::string& name) {
    return name + ".exe";
}

std::string library_name(const std::string& name) {
    return "lib" + name + ".dll";
}

std::string libraries_in(const std::filesystem::path& folder) {
    const char* const path = std::getenv("PATH");
    return "PATH=" + folder.string() + (path ? std::string{";"} + path : "");
}

std::optional<std::int64_t> last_written(const std::filesystem::path& file) {
    WIN32_FILE_ATTRIBUTE_DATA data{};
    if (!::GetFileAttributesExW(file.c_str(), GetFileExInfoStandard, &data)) return {};
    const FILETIME& time = data.ftLastWriteTime;
    return static_cast<std::int64_t>(std::uint64_t{time.dwHighDateTime} << 32 | time.dwLowDateTime);
}

void set_variable(const char* name, const char* value) {
    ::_putenv_s(name, value);
}

std::vector<std::string> command_words(const std::string& line) {
    int count = 0;
    wchar_t** const all = ::CommandLineToArgvW(wide(line).c_str(), &count);
    std::vector<std::string> words;
    for (int i = 0; i < count; ++i) words.push_back(narrow(all[i]));
    ::LocalFree(all);
    return words;
}

bool has_escapes(const char* terminal) {
    return !terminal || std::strcmp(terminal, "dumb") != 0;
}

std::string instead_of_sanitizers() {
    return "g++ has no sanitizers on Windows; in WSL, a Linux inside Windows, ./course check NN.k "
           "--sanitize names the line";
}

std::string machine() {
    wchar_t name[256] = L"";
    DWORD size = sizeof name;
    ::RegGetValueW(HKEY_LOCAL_MACHINE, L"HARDWARE\\DESCRIPTION\\System\\CentralProcessor\\0",
                   L"ProcessorNameString", RRF_RT_REG_SZ, nullptr, name, &size);
    std::string text = narrow(name);
    text.erase(text.find_last_not_of(' ') + 1);
    return (text.empty() ? "unknown processor" : text) + ", " +
           rt::counted(std::thread::hardware_concurrency(), "core") + ", Windows";
}

}  // namespace companion
