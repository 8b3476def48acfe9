#pragma once
// Catch2, version 3 or 2, as the system has it.
#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_translate_exception.hpp>
#else
#include <catch2/catch.hpp>
#endif

namespace checkpoint {
// How many passes through the test case that runs have begun without coming to its end.
extern int unfinished_passes;

// What a message tells the companion beside its text: the expected and the actual value stand each
// behind its mark, up to `end_mark` or the end of the line. A terminal does not show the marks.
inline constexpr char expected_mark = '\034', actual_mark = '\035', end_mark = '\036',
                      crash_mark = '\037', counts_mark = '\032';  // counts: see pictured.hpp
}  // namespace checkpoint

// These stand before the expected and the actual value in a message. If both are there and differ,
// the values of the assertion need not be shown. If several messages have an expected value, only
// the last one counts, because the others belong to earlier assertions.
#define EXPECTED "\036expected \034"
#define ACTUAL "\036actual \035"
// Begins a message that helps only if the code crashes.
#define IF_IT_CRASHES "\037Hint, if this crashes: "

// A test case knows whether it came to its end. Otherwise code that throws what Catch2 itself
// throws would end it, and nothing would have failed.
#undef TEST_CASE
#define TEST_CASE(...) CHECKPOINT_TEST_CASE(INTERNAL_CATCH_UNIQUE_NAME(checkpoint_), __VA_ARGS__)
#define CHECKPOINT_TEST_CASE(body, ...)    \
    static void body();                    \
    INTERNAL_CATCH_TESTCASE(__VA_ARGS__) { \
        ++checkpoint::unfinished_passes;   \
        body();                            \
        --checkpoint::unfinished_passes;   \
    }                                      \
    static void body()
