#include <catch.hpp>
#include <rt/standard_error.hpp>
