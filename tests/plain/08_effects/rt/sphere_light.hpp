#pragma once
#include <cmath>
#include <optional>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sphere.hpp>

namespace rt {
inline Real cone_height(Real radius, Real distance) {
    const Real sine = radius / distance;
    return sine * sine / (1 + std::sqrt(1 - sine * sine));
}
inline Real light_density(const Sphere& light, Vec3 from) {
    const Real d = length(light.center - from);
    if (d <= light.radius) return 1 / (4 * pi);
    return 1 / (2 * pi * cone_height(light.radius, d));
}
inline std::optional<LightSample> sample_light(const Sphere& light, Vec3 from, Vec2 place) {
    const Vec3 to_center = light.center - from;
    const Real d = length(to_center), r = light.radius;
    if (d <= r) return {};
    const Real h = cone_height(r, d), k = place.x * h;
    const Real cosine = 1 - k, sine = std::sqrt(k * (2 - k)), angle = 2 * pi * place.y;
    const Vec3 direction =
        normalize(orthonormal_basis(to_center / d)
                      .to_world({sine * std::cos(angle), sine * std::sin(angle), cosine}));
    const Real t = d * cosine - std::sqrt(r * r - d * d * sine * sine);
    return LightSample{direction, t, 1 / (2 * pi * h)};
}
inline Real shared_weight(Real density, Real other) {
    return density * density / (density * density + other * other);
}
}  // namespace rt
