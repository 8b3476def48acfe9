#pragma once
// What a wrong answer looks like from outside: which assertions fail, and with which values. Two
// answers that are wrong in the same way have the same signature, however they are written.

#include <companion/check/test_results.hpp>
#include <set>
#include <string>
#include <vector>

namespace companion {

struct Signature {
    // Hashes of the assertions that failed: test case and expression, no line numbers.
    std::set<std::string> where;
    // The same with the actual values, to three digits, so that the way an answer rounds does not
    // matter. If there are many, the smallest hashes are kept: an even sample of them.
    std::set<std::string> what;
};

// Test cases that an rt::todo ended are left out: they say nothing about what was written. So are
// stars where the core fails: a plain answer leaves them open, whatever else is wrong with it.
Signature signature_of(const std::vector<TestCase>& tests);

// How similar two signatures are, from 0 to 1: what both have as a share of what either has, with
// `where` and `what` weighted equally. 0 if one is empty.
double similarity(const Signature& a, const Signature& b);

bool operator==(const Signature& a, const Signature& b);

// Keeps the smallest of many hashes.
void keep_sample(std::set<std::string>& hashes);

// A text with its numbers rounded to three digits.
std::string with_rounded_numbers(const std::string& text);

}  // namespace companion
