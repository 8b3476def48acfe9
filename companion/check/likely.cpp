#include <algorithm>
#include <cctype>
#include <companion/check/likely.hpp>
#include <companion/model/source.hpp>
#include <set>
#include <utility>

namespace companion {
namespace {

// Each three words that follow each other in code, where every sign that is no letter is a word.
using Triples = std::set<std::string>;

Triples triples_of(const std::string& code) {
    const auto is_letter = [&](std::size_t i) {
        return std::isalnum(static_cast<unsigned char>(code[i])) || code[i] == '_';
    };
    Triples triples;
    std::string before_last, last;
    for (std::size_t i = 0; i < code.size();) {
        if (std::isspace(static_cast<unsigned char>(code[i]))) {
            ++i;
            continue;
        }
        std::size_t end = i + 1;
        if (is_letter(i))
            while (end < code.size() && is_letter(end)) ++end;
        const std::string word = code.substr(i, end - i);
        triples.insert(before_last + ' ' + last + ' ' + word);
        before_last = std::exchange(last, word);
        i = end;
    }
    return triples;
}

// Which share of the triples that `some` has and `others` lacks is in the code; half if there are
// no such triples.
double share_in(const Triples& code, const Triples& some, const Triples& others) {
    int in_code = 0, all = 0;
    for (const std::string& triple : some) {
        if (others.count(triple)) continue;
        ++all;
        in_code += code.count(triple) > 0;
    }
    return all == 0 ? 0.5 : static_cast<double>(in_code) / all;
}

// From -1, if the answer has the right code that the mistake replaces, to 1, if it has the
// mistake's.
double resemblance(const Mistake& mistake, const Triples& code) {
    double sum = 0;
    for (const Edit& edit : mistake.edits) {
        const Triples right = triples_of(code_of(edit.before)),
                      wrong = triples_of(code_of(edit.after));
        sum += share_in(code, wrong, right) - share_in(code, right, wrong);
    }
    return sum / static_cast<double>(mistake.edits.size());
}

}  // namespace

bool is_refuted(const Mistake& mistake, const std::vector<TestCase>& tests) {
    std::vector<std::string> failed, passed;
    for (const TestCase& test : tests) (test.passed ? passed : failed).push_back(test.name);
    return is_refuted(mistake, failed, passed);
}

std::vector<Mistake> likely_mistakes(const std::vector<Mistake>& all,
                                     const std::vector<TestCase>& tests, const std::string& code) {
    // A failing core says nothing about stars.
    const auto fails = [](const TestCase& test) {
        return !test.passed && missing_exercise(test).empty();
    };
    auto first = std::find_if(tests.begin(), tests.end(),
                              [&](const TestCase& test) { return fails(test) && !test.hard; });
    const bool core_fails = first != tests.end();
    if (!core_fails) first = std::find_if(tests.begin(), tests.end(), fails);
    const auto is_star = [&](const std::string& name) {
        return std::any_of(tests.begin(), tests.end(),
                           [&](const TestCase& test) { return test.hard && test.name == name; });
    };
    // An answer that has a mistake's code has that mistake, whichever test case fails first.
    constexpr double weight = 0.3;
    const Triples triples = triples_of(code);
    std::vector<std::pair<double, const Mistake*>> scored;
    for (const Mistake& mistake : all) {
        if (!may_be(mistake, code) || is_refuted(mistake, tests)) continue;
        double score = resemblance(mistake, triples);
        if (first != tests.end() && mistake.caught_by == first->name) score += weight;
        if (core_fails && is_star(mistake.caught_by)) score -= weight;
        scored.push_back({score, &mistake});
    }
    std::stable_sort(scored.begin(), scored.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Mistake> likely;
    for (const auto& [score, mistake] : scored) likely.push_back(*mistake);
    return likely;
}

}  // namespace companion
