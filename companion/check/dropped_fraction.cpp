#include <algorithm>
#include <companion/check/dropped_fraction.hpp>
#include <companion/model/source.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace companion {
namespace {

std::vector<std::string> words_of(const std::string& text) {
    static const std::regex word{R"(\w+)"};
    return {std::sregex_token_iterator{text.begin(), text.end(), word}, {}};
}

bool is_number(const std::string& word) {
    return word.size() < 6 && word.find_first_not_of("0123456789") == word.npos;
}

}  // namespace

std::string dropped_fraction(const std::string& text) {
    static const std::regex declared{R"(\bint \w+\b(?!\())"},
        wanted{R"(\b(double|float|Real|real)\b)"},
        // Not after `)`, `]`, `.`, `*` or `/`, because then the dividend has more to it.
        quotient{R"((?:^|[^\w\s.)\]*/]|\breturn)\s*((?:\w+ *\* *)*\w+) */ *(\w+)(?![\w.(:\[]|->))"};
    const std::string code = code_of(text);
    std::set<std::string> whole;  // names
    for (std::sregex_iterator one{code.begin(), code.end(), declared}, end; one != end; ++one)
        whole.insert(words_of(one->str()).back());
    std::istringstream lines{text};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        line = code_of(line);
        for (std::sregex_iterator one{line.begin(), line.end(), quotient}, end; one != end; ++one) {
            const std::vector<std::string> factors = words_of((*one)[1]);
            const std::string divisor = (*one)[2];
            long long dividend = 1;
            bool all_whole = is_number(divisor) || whole.count(divisor),
                 all_numbers = is_number(divisor);
            for (const std::string& factor : factors) {
                all_whole = all_whole && (is_number(factor) || whole.count(factor));
                all_numbers = all_numbers && is_number(factor);
                if (all_numbers) dividend *= std::stoi(factor);
            }
            const bool drops = all_numbers
                                   ? std::stoi(divisor) != 0 && dividend % std::stoi(divisor) != 0
                                   : all_whole && std::regex_search(line, wanted);
            // Whoever also takes the remainder means it.
            const std::string written = (*one)[1];
            if (drops && code.find(written + " % " + divisor) == code.npos)
                return std::to_string(number) + ": `" + written + " / " + divisor +
                       "` divides whole numbers, which drops the fraction: 1 / 2 is 0, and "
                       "1.0 / 2 is 0.5.";
        }
    }
    return "";
}

}  // namespace companion
