#pragma once
#include <string>

namespace companion {

// Text escaped for HTML.
std::string escape_html(const std::string& text);

}  // namespace companion
