#pragma once
// Texts in the form that Windows functions expect.

#include <string>

namespace companion {

// Converts from UTF-8, and to UTF-8.
std::wstring wide(const std::string& text);
std::string narrow(const std::wstring& text);

// The system's message about the last function that failed.
std::string last_error();

}  // namespace companion
