#include <catch.hpp>
#include <rt/denoise.hpp>
