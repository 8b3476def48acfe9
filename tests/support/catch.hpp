#pragma once
// Catch2, version 3 or 2, as the system has it.
#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_translate_exception.hpp>
#else
#include <catch2/catch.hpp>
#endif
