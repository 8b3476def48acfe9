#pragma once
#include <string>

namespace companion {

// Markdown as a terminal can show it: without backticks, and formulas between $ in plain
// characters, "a · b ≤ √(1 - x)" for "$\mathbf a\cdot\mathbf b \le \sqrt{1 - x}$". What it does not
// know stays. Indented blocks of code stay as they are.
std::string plain_text(const std::string& markdown);

}  // namespace companion
