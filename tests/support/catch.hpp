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
}  // namespace checkpoint

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
