#pragma once
// What operating systems name or provide in different ways: posix/platform.cpp and
// windows/platform.cpp define the same functions.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace companion {

// The file name of a program, such as "check.03.2" or "check.03.2.exe".
std::string program_name(const std::string& name);

// The file name of a shared library, such as "libanswer.03.2.so".
std::string library_name(const std::string& name);

// An argument for the command env, "NAME=VALUE", so that a program finds its shared libraries in
// this folder.
std::string libraries_in(const std::filesystem::path& folder);

// When a file was last written, in the units of the file system; nothing if it is missing. (On
// Windows, std::filesystem::last_write_time counts whole seconds, and would miss a second save.)
std::optional<std::int64_t> last_written(const std::filesystem::path& file);

// Sets a variable of the environment, for this program and those that it runs.
void set_variable(const char* name, const char* value);

// A line that starts a program, in words, as the system takes it apart: without the quotes, and
// without the backslashes where they are not the names of folders.
std::vector<std::string> command_words(const std::string& line);

// Whether a terminal of this type, as TERM names it, understands escape sequences for colors.
bool has_escapes(const char* terminal);

// What to do where compilers have no sanitizers; empty if they have sanitizers.
std::string instead_of_sanitizers();

// A description of the machine: "AMD Ryzen 7 5800X, 16 cores, Linux".
std::string machine();

}  // namespace companion
