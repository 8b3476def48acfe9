#include <algorithm>
#include <cctype>
#include <companion/check/signature.hpp>
#include <companion/system/files.hpp>
#include <cstdio>
#include <cstdlib>

namespace companion {
namespace {

constexpr std::size_t most_kept = 32;

// Eight digits are enough to tell the failures of one exercise apart.
std::string short_hash(const std::string& text) {
    return hash_of(text).substr(8);
}

std::size_t common(const std::set<std::string>& a, const std::set<std::string>& b) {
    std::size_t count = 0;
    for (const std::string& item : a) count += b.count(item);
    return count;
}

// The size of the intersection divided by the size of the union (Jaccard index).
double overlap(const std::set<std::string>& a, const std::set<std::string>& b) {
    const std::size_t both = common(a, b), either = a.size() + b.size() - both;
    return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either);
}

// The same, but estimated from the smallest hashes of the two sets: together they are a fair sample
// of the union.
double sampled_overlap(const std::set<std::string>& a, const std::set<std::string>& b) {
    if (a.size() < most_kept && b.size() < most_kept) return overlap(a, b);
    std::set<std::string> either = a;
    either.insert(b.begin(), b.end());
    std::size_t seen = 0, both = 0;
    for (const std::string& item : either) {
        if (seen == most_kept) break;
        ++seen;
        both += a.count(item) && b.count(item);
    }
    return static_cast<double>(both) / static_cast<double>(seen);
}

}  // namespace

Signature signature_of(const std::vector<TestCase>& tests) {
    const bool core_fails = std::any_of(tests.begin(), tests.end(), [](const TestCase& test) {
        return !test.hard && !test.passed && missing_exercise(test).empty();
    });
    Signature signature;
    for (const TestCase& test : tests) {
        if ((test.hard && core_fails) || !missing_exercise(test).empty()) continue;
        for (const FailedAssertion& failure : test.failures) {
            const std::string where = test.name + '\n' + failure.expression;
            signature.where.insert(short_hash(where));
            // Earlier messages may be about other functions.
            const Message* said = failure.expectation();
            if (!said && !failure.messages.empty()) said = &failure.messages.back();
            signature.what.insert(
                short_hash(where + '\n' +
                           with_rounded_numbers(failure.expanded + '\n' + failure.exception + '\n' +
                                                (said ? said->text : ""))));
        }
        if (test.broke_off()) {
            const std::string where = test.name + "\nnever ended";
            signature.where.insert(short_hash(where));
            signature.what.insert(short_hash(where));
        }
    }
    keep_sample(signature.what);
    return signature;
}

double similarity(const Signature& a, const Signature& b) {
    // If the values depend on chance, the file records no values, and only those assertions that
    // always fail. These assertions must have failed; others that failed count less.
    if (a.what.empty() || b.what.empty()) {
        const auto fewest = static_cast<double>(std::min(a.where.size(), b.where.size()));
        if (fewest == 0) return 0;
        const double contained = static_cast<double>(common(a.where, b.where)) / fewest;
        return (contained + overlap(a.where, b.where)) / 2;
    }
    return (overlap(a.where, b.where) + sampled_overlap(a.what, b.what)) / 2;
}

bool operator==(const Signature& a, const Signature& b) {
    return a.where == b.where && a.what == b.what;
}

void keep_sample(std::set<std::string>& hashes) {
    while (hashes.size() > most_kept) hashes.erase(--hashes.end());
}

std::string with_rounded_numbers(const std::string& text) {
    std::string rounded;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = [&](std::size_t at) {
            return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
        };
        // The sign of a NaN depends on the compiler.
        if (text.compare(i, 4, "-nan") == 0) ++i;
        const bool in_word = i > 0 && (std::isalnum(byte(i - 1)) || text[i - 1] == '_');
        const bool number = std::isdigit(byte(i)) || (text[i] == '.' && std::isdigit(byte(i + 1)));
        if (!number || in_word) {
            rounded += text[i++];
            continue;
        }
        char* end = nullptr;
        const double value = std::strtod(text.c_str() + i, &end);
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "%.3g", value);
        rounded += buffer;
        i = static_cast<std::size_t>(end - text.c_str());
    }
    return rounded;
}

}  // namespace companion
