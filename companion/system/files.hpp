#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace companion {

// Why there is no file to read at a path: "is missing", "is a folder, not a file"; empty if there
// is a file. Pipes count as no file, because opening one would wait until somebody writes into it.
std::string why_no_file(const std::filesystem::path& path);

// The contents of a file. Throws app::Failure if it cannot be read.
std::string read_file(const std::filesystem::path& path);

// The contents of a text file with Unix line ends: editors and Git for Windows may put a carriage
// return at the end of each line, which is left out.
std::string read_text(const std::filesystem::path& path);

// The same; empty if there is no file, or none any more once it is to be read: editors remove files
// in order to write them anew.
std::string text_if_there(const std::filesystem::path& path);

// Copies a folder with all that is in it. (On Windows, std::filesystem::copy refuses: it takes the
// two folders for the same one.)
void copy_folder(const std::filesystem::path& from, const std::filesystem::path& to);

// The files in a folder and its subfolders, sorted; none if the folder does not exist. An editor's
// temporary files, whose names start with . or # or end with ~, are left out.
std::vector<std::filesystem::path> source_files(const std::filesystem::path& folder);

// A hash of the bytes, 16 hexadecimal digits: if the bytes differ, it almost certainly differs,
// too. Source: Fowler, Noll and Vo's FNV-1a.
std::string hash_of(const std::string& bytes);

}  // namespace companion
