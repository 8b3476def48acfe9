#pragma once
#include <string>

namespace companion {

// Text escaped for HTML.
std::string escape_html(const std::string& text);

// Bytes as text, for data: addresses.
std::string base64(const std::string& bytes);

}  // namespace companion
