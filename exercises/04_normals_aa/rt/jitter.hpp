#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color_sum.hpp>
#include <rt/directions.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 04.5. The pixel is cut into n x n cells; cell 0 is the top left one, cell n the first of
// the second row. `place` is a sample point within the cell with the number `cell`, 0 <= x, y < 1.
// Returns the offset of that point within the pixel. Cell k of a row extends from k / n, which
// belongs to it, to (k + 1) / n, which does not.
// Star: the offset stays below (k + 1) / n, although the sum and the division are rounded.
inline Vec2 jittered_offset(int cell, int n, Vec2 place) {
    return rt::todo("04.5", cell, n, place);
}

// Exercise 04.5. The average color of a pixel over this many samples, 1 or more, in any order.
// sample(offset) is called with a random offset in each cell of the finest n x n grid that has no
// more cells than there are samples. For each sample that remains, it is called with a random
// offset anywhere in the pixel. Each offset is made from a random sample point of its own.
// Star: in float, too, the average of a million samples is accurate. ColorSum, from
// rt/color_sum.hpp, adds them up in double.
template <class Random, class Sample>
Color pixel_average(int samples, Random& random, Sample sample) {
    return rt::todo("04.5", samples, random, sample);
}

}  // namespace rt
