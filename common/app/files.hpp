#pragma once
// Writing files and making folders, so that nothing half-written is left.

#include <filesystem>
#include <string>

namespace app {

// Replaces the file as a whole: the bytes go to a new file beside it, which then takes its name, so
// that a reader sees the old file or the new one, never a part. A path that is no regular file (a
// device, a pipe) is written to directly; a pipe without a reader fails.
// Throws std::system_error when it cannot; then an older file is as it was and no new one is left.
void replace_file(const std::filesystem::path& path, const std::string& bytes);

// The file that a path means: through links the one that they point to, there or not. Throws
// std::system_error where they lead in a circle.
std::filesystem::path behind_links(std::filesystem::path path);

// Makes a folder where it is missing. Throws Failure where it cannot.
void make_folder(const std::filesystem::path& folder);

}  // namespace app
