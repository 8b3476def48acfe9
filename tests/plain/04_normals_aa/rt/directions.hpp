#pragma once
#include <cmath>
#include <rt/length.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/vec2.hpp>

namespace rt {

inline Vec3 cosine_direction(Vec3 normal, Vec2 place) {
    const Real radius = std::sqrt(place.x), turn = 2 * pi * place.y;
    return normalize(orthonormal_basis(normal).to_world(
        {radius * std::cos(turn), radius * std::sin(turn), std::sqrt(1 - place.x)}));
}

template <class Random>
Vec2 random_place(Random& random) {
    const Real x = random.uniform(), y = random.uniform();
    return {x, y};
}

}  // namespace rt
