#pragma once
#include <cmath>
#include <optional>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/sphere.hpp>
#include <rt/uniform_direction.hpp>
#include <rt/vec2.hpp>

namespace rt {

inline Real cone_height(Real radius, Real distance) {
    const Real sine = radius / distance;
    return sine * sine / (1 + std::sqrt(1 - sine * sine));
}

inline Real light_density(const Sphere& light, Vec3 from) {
    const Real distance = length(light.center - from);
    if (distance <= light.radius) return 1 / (4 * pi);
    return 1 / (2 * pi * cone_height(light.radius, distance));
}

inline std::optional<LightSample> sample_light(const Sphere& light, Vec3 from, Vec2 place) {
    const Vec3 apart = light.center - from;
    const Real d = length(apart), r = light.radius;
    if (d <= r) return {};
    const Real k = place.x * cone_height(r, d), turn = 2 * pi * place.y;
    const Real cosine = 1 - k, sine = std::sqrt(k * (2 - k));
    const Vec3 direction = normalize(orthonormal_basis(apart / d).to_world(
        {sine * std::cos(turn), sine * std::sin(turn), cosine}));
    const Real t = d * cosine - std::sqrt(r * r - d * d * sine * sine);
    return LightSample{direction, t, light_density(light, from)};
}

}  // namespace rt
