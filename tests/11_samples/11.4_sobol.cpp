#include <catch.hpp>
#include <rt/sobol.hpp>
