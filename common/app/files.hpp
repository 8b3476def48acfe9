#pragma once
// Reading files that people name, writing files without ever leaving one half-written, and creating
// folders.

#include <filesystem>
#include <optional>
#include <string>

namespace app {

// Replaces the file as a whole: the bytes go to a new file beside it, which then takes its name. So
// a reader sees the old file or the new one, never a part. A path that is not a regular file (a
// device, a pipe) is written to directly; a pipe without a reader fails. Throws std::system_error
// on failure; an older file is then unchanged, and no new one is left behind.
void replace_file(const std::filesystem::path& path, const std::string& bytes);

// The file that a path means: links are followed to the file that they point to, whether that file
// exists or not. Throws std::system_error if the links form a circle.
std::filesystem::path behind_links(std::filesystem::path path);

// The contents of a file; of a file of more than `most` bytes only a beginning that is longer than
// that. None if it cannot be read; errno says why.
std::optional<std::string> read_bytes(const std::filesystem::path& path,
                                      std::size_t most = std::string::npos);

// The contents of a regular file of at most `most` bytes. Throws UsageError, whose message begins
// with `name`, if the file is missing, is too large, cannot be read, or is a folder or a device.
std::string read_input_file(const std::filesystem::path& path, const std::string& name,
                            std::size_t most);

// Creates a folder if it is missing. Throws Failure if that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace app
