#pragma once
// Reading C++, roughly: enough to know what is code, and which functions there are.

#include <string>
#include <vector>

namespace companion {

// The code without comments and, unless they are to be kept, without the contents of strings. The
// text may break off anywhere.
std::string code_of(const std::string& text, bool keep_strings = false);

// The functions that a header defines at namespace level: everything up to the body, without
// `inline` and the like, words one space apart.
std::vector<std::string> signatures(const std::string& text);

}  // namespace companion
