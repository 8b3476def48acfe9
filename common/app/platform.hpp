#pragma once
// What programs ask of the operating system, where systems differ: posix/platform.cpp and
// windows/platform.cpp have the same functions.

#include <cstdio>
#include <filesystem>

namespace app {

// What every program of the course does first. After that, a file that reaches its size limit is an
// error and not a crash, a crash opens no window, and what is printed has the same bytes on all
// systems.
void prepare_process();

// Ends the program as this signal would if it were not handled.
void end_by(int signal);

// What happens at a signal: SIG_DFL, SIG_IGN or a handler.
using SignalHandler = void (*)(int);
SignalHandler handler_of(int signal);

// Opens a file whose bytes are to be read. Null if that fails; errno says why.
std::FILE* open_for_reading(const std::filesystem::path& path);

// Opens a file for writing. A missing file is created; an existing file is emptied or, with
// `only_new`, is an error. Null if opening fails; errno says why. A pipe without a reader is an
// error.
std::FILE* open_for_writing(const std::filesystem::path& path, bool only_new);

// Renames a file. If another file already has the new name, that file is replaced. Throws
// std::filesystem::filesystem_error.
void rename_over(const std::filesystem::path& from, const std::filesystem::path& to);

// Removes a file, if there is one. May be called in a signal handler.
void remove_now(const std::filesystem::path::value_type* path);

// True if this file, or files in this folder, may be written. If not, errno says why.
bool is_writable(const std::filesystem::path& path);

// True if what is written to this file appears on a terminal, where a person reads it.
bool is_terminal(std::FILE* file);

}  // namespace app
