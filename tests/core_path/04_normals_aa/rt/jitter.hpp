#pragma once
#include <cmath>
#include <rt/color.hpp>
#include <rt/directions.hpp>
#include <rt/vec2.hpp>

namespace rt {
inline Vec2 jittered_offset(int cell, int n, Vec2 place) {
    const int column = cell % n, row = cell / n;
    return {(static_cast<Real>(column) + place.x) / static_cast<Real>(n),
            (static_cast<Real>(row) + place.y) / static_cast<Real>(n)};
}
template <class Random, class Sample>
Color pixel_average(int samples, Random& random, Sample sample) {
    const int n = static_cast<int>(std::sqrt(samples));
    Color sum;
    for (int cell = 0; cell < n * n; ++cell)
        sum += sample(jittered_offset(cell, n, random_place(random)));
    for (int i = n * n; i < samples; ++i) sum += sample(random_place(random));
    return sum / static_cast<Real>(samples);
}
}  // namespace rt
