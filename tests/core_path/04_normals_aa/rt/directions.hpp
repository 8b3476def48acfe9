#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/vec2.hpp>

namespace rt {
inline Vec3 uniform_direction(Vec2 place) {
    const Real z = 1 - 2 * place.x;
    const Real radius = 2 * std::sqrt(place.x * (1 - place.x));
    const Real angle = 2 * pi * place.y;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}
inline Vec3 cosine_direction(Vec3 normal, Vec2 place) {
    const Real radius = std::sqrt(place.x);
    const Real angle = 2 * pi * place.y;
    return normalize(orthonormal_basis(normal).to_world(
        {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1 - place.x)}));
}
template <class Random>
Vec2 random_place(Random& random) {
    const Real x = random.uniform(), y = random.uniform();
    return {x, y};
}
}  // namespace rt
