// NAME.exe WORDS...: under wine, stands in for a program of Windows such as cmake. It runs the
// program NAME of Linux through linux_program.sh, prints what that printed, and ends with its exit
// code.
#include <windows.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

namespace fs = std::filesystem;

int main(int, char** argv) {
    const std::string name = fs::path{argv[0]}.stem().string();
    // Wine's pipes mean nothing to Linux, so both sides know this file.
    const std::string said = "/tmp/linux-program-" + std::to_string(::GetCurrentProcessId()) + '-' +
                             std::to_string(::GetTickCount64());
    const std::string words = ::GetCommandLineA();
    const auto end = words[0] == '"' ? words.find('"', 1) + 1 : words.find(' ');
    std::string line = "sh \"" LINUX_PROGRAM_SH "\" " + said + ' ' + name +
                       (end < words.size() ? words.substr(end) : std::string{});
    STARTUPINFOA start{};
    start.cb = sizeof start;
    PROCESS_INFORMATION made{};
    if (!::CreateProcessA("Z:\\bin\\sh", line.data(), nullptr, nullptr, FALSE, 0, nullptr, nullptr,
                          &start, &made))
        return 127;
    // There is no handle to wait for.
    const fs::path file = "Z:" + said, code_file = "Z:" + said + ".code";
    while (!fs::exists(code_file)) ::Sleep(5);
    int code = 127;
    std::ifstream{code_file} >> code;
    std::cout << std::ifstream{file, std::ios::binary}.rdbuf() << std::flush;
    fs::remove(file);
    fs::remove(code_file);
    return code;
}
