#pragma once
#include <string>

namespace companion {

// Text as HTML shows it.
std::string escape_html(const std::string& text);

}  // namespace companion
