#pragma once
#include <algorithm>
#include <string_view>

namespace rt {

// Removes the first word from a line and returns it. Returns an empty text if the line has no word.
inline std::string_view take_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t\r\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

}  // namespace rt
