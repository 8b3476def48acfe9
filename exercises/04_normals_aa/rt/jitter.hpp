#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color_sum.hpp>
#include <rt/directions.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 04.5. The pixel is cut into n x n cells; cell 0 is the top left one, cell n the
// first of the second row. Turns `place`, a sample point within a cell, 0 <= x, y < 1, into its
// offset within the pixel. Cell k of a row reaches from k / n, which belongs to it, to
// (k + 1) / n, which does not.
// Star: both the sum and the division round, and still the quotient stays below (k + 1) / n.
inline Vec2 jittered_offset(int cell, int n, Vec2 place) {
    return rt::todo("04.5", cell, n, place);
}

// Exercise 04.5. The average color of a pixel over this many samples, 1 or more. sample(offset) is
// called with one random offset in each cell of the finest n x n grid that the samples suffice for,
// and with offsets anywhere in the pixel for the rest of them, each with a random place of its own.
// The samples may come in any order.
// Star: the average of a million samples is not off in float, either. ColorSum, from
// rt/color_sum.hpp, adds them up in double.
template <class Random, class Sample>
Color pixel_average(int samples, Random& random, Sample sample) {
    return rt::todo("04.5", samples, random, sample);
}

}  // namespace rt
