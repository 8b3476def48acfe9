#pragma once
#include <string>

namespace companion {

// "7: `1 / 2` divides whole numbers, ...": the line and the words for the first quotient in this
// text that drops a fraction which is wanted: a quotient of numbers as they are written, or one of
// variables of type int in a line that is about a Real or a double. Compilers do not warn of it.
// Empty if there is none.
std::string dropped_fraction(const std::string& text);

}  // namespace companion
