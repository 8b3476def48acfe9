// The entry point of every program of test cases. Catch2 3 brings its own main().
#if !__has_include(<catch2/catch_test_macros.hpp>)
#define CATCH_CONFIG_MAIN
#include "catch.hpp"
#endif
