#pragma once
// Which of the known mistakes to try first on a wrong answer.

#include <companion/check/test_results.hpp>
#include <companion/model/mistakes.hpp>

namespace companion {

// Whether these results of the test cases rule a mistake out.
bool is_refuted(const Mistake& mistake, const std::vector<TestCase>& tests);

// The mistakes that an answer with these results can contain, the likeliest first: those that the
// first failing test case is meant to catch, and those whose code resembles the answer's. `code` is
// the answer's, without comments.
std::vector<Mistake> likely_mistakes(const std::vector<Mistake>& all,
                                     const std::vector<TestCase>& tests, const std::string& code);

}  // namespace companion
