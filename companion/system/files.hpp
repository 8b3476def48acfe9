#pragma once
#include <filesystem>
#include <string>

namespace companion {

// All of a file. Throws app::Failure where it cannot be read.
std::string read_file(const std::filesystem::path& path);

// A number that differs, all but certainly, where the bytes do: 16 hexadecimal digits.
// Source: Fowler, Noll and Vo's FNV-1a.
std::string hash_of(const std::string& bytes);

}  // namespace companion
