#include <catch.hpp>
#include <rt/running_variance.hpp>
