#pragma once
// Texts as this system's functions take them.

#include <string>

namespace companion {

// From UTF-8, and into it.
std::wstring wide(const std::string& text);
std::string narrow(const std::wstring& text);

// What went wrong in the system's last function, in its words.
std::string last_error();

}  // namespace companion
