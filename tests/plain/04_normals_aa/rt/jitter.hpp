#pragma once
#include <algorithm>
#include <cmath>
#include <rt/color_sum.hpp>
#include <rt/directions.hpp>
#include <rt/vec2.hpp>

namespace rt {

inline Vec2 jittered_offset(int cell, int n, Vec2 place) {
    const auto count = static_cast<Real>(n);
    return {(static_cast<Real>(cell % n) + place.x) / count,
            (static_cast<Real>(cell / n) + place.y) / count};
}

template <class Random, class Sample>
Color pixel_average(int samples, Random& random, Sample sample) {
    int n = 1;
    while ((n + 1) * (n + 1) <= samples) ++n;
    Color sum;
    for (int cell = 0; cell < n * n; ++cell)
        sum += sample(jittered_offset(cell, n, random_place(random)));
    for (int rest = n * n; rest < samples; ++rest) sum += sample(random_place(random));
    return sum / static_cast<Real>(samples);
}

}  // namespace rt
