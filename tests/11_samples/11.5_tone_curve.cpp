#include <catch.hpp>
#include <rt/tone_curve.hpp>
