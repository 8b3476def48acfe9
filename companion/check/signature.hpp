#pragma once
// What a wrong answer looks like from outside: which assertions fail, and with which values. Two
// answers that are wrong in the same way have the same signature, however they are written.

#include <companion/check/test_results.hpp>
#include <set>
#include <string>
#include <vector>

namespace companion {

struct Signature {
    // Hashes of the assertions that failed: of test case and expression, without line numbers.
    std::set<std::string> where;
    // Hashes that also cover the actual values, rounded to three digits so that different rounding
    // errors do not matter. If there are many hashes, only the smallest are kept, as a fair sample.
    std::set<std::string> what;
};

// Leaves out test cases that an rt::todo ended, because they say nothing about what was written. If
// the core fails, stars are left out, too: a simple answer leaves them open, whatever else is wrong
// with it.
Signature signature_of(const std::vector<TestCase>& tests);

// How similar two signatures are, from 0 to 1: the number of hashes that they share, divided by the
// number of hashes that either has, with `where` and `what` weighted equally. 0 if one is empty.
double similarity(const Signature& a, const Signature& b);

bool operator==(const Signature& a, const Signature& b);

// Keeps the smallest of many hashes.
void keep_sample(std::set<std::string>& hashes);

// A text with its numbers rounded to three digits.
std::string with_rounded_numbers(const std::string& text);

}  // namespace companion
