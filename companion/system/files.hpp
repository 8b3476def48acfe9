#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace companion {

// Why there is no file to read at a path, "is missing", "is a folder, not a file"; empty if there
// is one. Opening a pipe would wait until somebody writes into it.
std::string why_no_file(const std::filesystem::path& path);

// The contents of a file. Throws app::Failure if it cannot be read.
std::string read_file(const std::filesystem::path& path);

// The contents of a text file, with the line ends of Unix: editors and Git for Windows may put a
// carriage return before each.
std::string read_text(const std::filesystem::path& path);

// The files in a folder and in its folders, in order; none if the folder does not exist. An
// editor's own files, whose names start with . or # or end with ~, are left out.
std::vector<std::filesystem::path> source_files(const std::filesystem::path& folder);

// A number that differs, almost certainly, if the bytes do: 16 hexadecimal digits. Source:
// Fowler, Noll and Vo's FNV-1a.
std::string hash_of(const std::string& bytes);

}  // namespace companion
