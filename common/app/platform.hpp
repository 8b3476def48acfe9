#pragma once
// What programs ask of the operating system, where systems differ: posix/platform.cpp and
// windows/platform.cpp have the same functions.

#include <cstdio>
#include <filesystem>

namespace app {

// What every program of the course does first. A file that may not grow is then an error and no
// crash; a crash opens no window; and what is printed has the same bytes on all systems.
void prepare_process();

// Ends the program as a signal does that it does not handle.
void end_by(int signal);

// What happens at a signal: SIG_DFL, SIG_IGN or a handler.
using SignalHandler = void (*)(int);
SignalHandler handler_of(int signal);

// Opens a file whose bytes are to be read. Null if it cannot be; errno says why.
std::FILE* open_for_reading(const std::filesystem::path& path);

// Creates a file, or empties the one that exists unless `only_new`. Null if it cannot be; errno
// says why. A pipe without a reader is an error.
std::FILE* open_for_writing(const std::filesystem::path& path, bool only_new);

// Gives a file another name, in place of the file that has it. Throws
// std::filesystem::filesystem_error.
void rename_over(const std::filesystem::path& from, const std::filesystem::path& to);

// Removes a file, if there is one. May be called in a signal handler.
void remove_now(const std::filesystem::path::value_type* path);

// Whether a file may be written, or files in a folder. If not, errno says why.
bool is_writable(const std::filesystem::path& path);

// Whether a person sees what goes there.
bool is_terminal(std::FILE* file);

}  // namespace app
