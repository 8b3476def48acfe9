#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace app {

// The known word that was probably meant: the one with the fewest slips (a letter too many, missing
// or wrong, or two neighbors swapped). The result is empty if every known word has more than `most`
// slips; by default, `most` is a third of the letters, but at least 1.
std::string nearest_word(const std::string& wrong, const std::vector<std::string>& words);
std::string nearest_word(const std::string& wrong, const std::vector<std::string>& words,
                         std::size_t most);

}  // namespace app
