#pragma once
// Reads C++ roughly: enough to know what is code, and which functions there are.

#include <string>
#include <vector>

namespace companion {

// The code without comments and, unless `keep_strings` is true, without the contents of strings.
// The text may break off anywhere.
std::string code_of(const std::string& text, bool keep_strings = false);

// The functions that a header defines at namespace level: everything before the body, without
// `inline` and similar words, with single spaces between words.
std::vector<std::string> signatures(const std::string& text);

}  // namespace companion
