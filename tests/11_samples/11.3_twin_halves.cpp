#include <catch.hpp>
#include <rt/twin_halves.hpp>
