#include <algorithm>
#include <app/nearest_word.hpp>

namespace app {
namespace {

// The smallest number of slips that turn one word into the other. A slip is a letter inserted,
// removed or changed, or two neighbors swapped.
std::size_t slips(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> table(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                table[i][j] = i + j;
                continue;
            }
            table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1,
                                    table[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
        }
    return table[a.size()][b.size()];
}

}  // namespace

std::string nearest_word(const std::string& wrong, const std::vector<std::string>& words) {
    // A third of the letters may be wrong, but always at least one.
    return nearest_word(wrong, words, std::max<std::size_t>(wrong.size() / 3, 1));
}

std::string nearest_word(const std::string& wrong, const std::vector<std::string>& words,
                         std::size_t most) {
    std::string nearest;
    std::size_t best = most;
    if (wrong.size() > 40) return {};  // a text longer than a word is not a slip
    for (const std::string& word : words) {
        // The beginning of a word is taken for the whole word.
        if (wrong.size() >= 3 && word.rfind(wrong, 0) == 0) return word;
        const std::size_t count = slips(wrong, word);
        if (count < best || (count == best && nearest.empty())) {
            best = count;
            nearest = word;
        }
    }
    return nearest;
}

}  // namespace app
