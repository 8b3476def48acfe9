#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color_sum.hpp>
#include <rt/directions.hpp>
#include <rt/vec2.hpp>

namespace rt {

// The pixel is cut into n x n cells; cell 0 is the top left one, cell n the first of the second
// row. `place` is a sample point within the cell with the number `cell`, 0 <= x, y < 1. Returns the
// offset of that point within the pixel. Cell k of a row extends from k / n, which belongs to it,
// to (k + 1) / n, which does not, even after rounding.
inline Vec2 jittered_offset(int cell, int n, Vec2 place) {
    const auto within = [n](int k, Real x) {
        const auto count = static_cast<Real>(n), first = static_cast<Real>(k);
        // first + x may round up to the next cell's edge.
        const Real end = std::nextafter((first + 1) / count, Real(0));
        return std::min((first + x) / count, end);
    };
    return {within(cell % n, place.x), within(cell / n, place.y)};
}

// The average color of a pixel over this many samples, 1 or more. sample(offset) is called with a
// random offset in each cell of the finest n x n grid that has no more cells than there are
// samples, and with a random offset anywhere in the pixel for each sample that remains; all offsets
// are independent. ColorSum keeps the average of many samples accurate even in float.
template <class Random, class Sample>
Color pixel_average(int samples, Random& random, Sample sample) {
    int n = 1;
    while ((n + 1) * (n + 1) <= samples) ++n;
    ColorSum sum;
    for (int cell = 0; cell < n * n; ++cell)
        sum.add(sample(jittered_offset(cell, n, random_place(random))));
    for (int rest = n * n; rest < samples; ++rest) sum.add(sample(random_place(random)));
    return sum.mean(samples);
}

}  // namespace rt
