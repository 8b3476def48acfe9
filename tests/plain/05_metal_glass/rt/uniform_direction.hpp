#pragma once
#include <cmath>
#include <rt/vec2.hpp>
#include <rt/vec3.hpp>

namespace rt {

inline Vec3 uniform_direction(Vec2 place) {
    const Real z = 1 - 2 * place.x;
    const Real radius = std::sqrt(1 - z * z), turn = 2 * pi * place.y;
    return {radius * std::cos(turn), radius * std::sin(turn), z};
}

}  // namespace rt
