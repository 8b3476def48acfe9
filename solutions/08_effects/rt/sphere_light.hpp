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

// 1 - cos a, where a is the angle between the light's center and its rim, as seen from a point at
// this distance from the center, outside the light. The result is computed from sin a = radius /
// distance, without the cancellation of 1 - cos a for lights that are small or far. It is within 7
// units in the last place if it is at least std::numeric_limits<Real>::min().
inline Real cone_height(Real radius, Real distance) {
    const Real sine = radius / distance;
    // (d - r) (d + r) / d^2 instead of 1 - sine^2, which cancels close to the light.
    const Real cosine =
        std::sqrt((distance - radius) / distance * ((distance + radius) / distance));
    return sine * sine / (1 + cosine);
}

// The probability density, per solid angle, with which sample_light chooses a direction that meets
// the light: 1 / its solid angle. 0 if cone_height is less than std::numeric_limits<Real>::min().
inline Real light_density(const Sphere& light, Vec3 from) {
    const Real distance = length(light.center - from);
    // Seen from inside, or from a point on its surface, the light is in every direction.
    if (distance <= light.radius) return 1 / (4 * pi);
    const Real height = cone_height(light.radius, distance);
    // If height has few digits left, 1 / height could be infinite.
    return std::isnormal(height) ? 1 / (2 * pi * height) : 0;
}

// A direction to a sphere that shines: every direction in which it is seen from the
// point is equally likely. None if light_density is 0. `place` is a sample point of the
// unit square, 0 <= x, y < 1.
// Source: Wang, "Physically correct direct lighting for distribution ray tracing", Graphics Gems
// III, 1992; here in terms that do not cancel.
inline std::optional<LightSample> sample_light(const Sphere& light, Vec3 from, Vec2 place) {
    const Vec3 apart = light.center - from;
    const Real distance = length(apart), radius = light.radius;
    if (distance <= radius) {
        const Vec3 direction = uniform_direction(place);
        // All lengths are divided by the radius, so that no product overflows.
        const Real along = dot(apart / radius, direction);
        const Real product = (radius - distance) / radius * ((radius + distance) / radius);
        const Real root = std::sqrt(along * along + product);
        // The far root of t^2 - 2 along t - product, in whichever of its two forms does not cancel.
        const Real far = radius * (along >= 0 ? along + root : product / (root - along));
        return LightSample{direction, far, 1 / (4 * pi)};
    }
    const Real whole = cone_height(radius, distance);
    if (!std::isnormal(whole)) return {};
    // Archimedes once more: the heights of a cap's points are spread evenly. `height` is 1 - cos of
    // the angle to the center.
    const Real height = place.x * whole;
    const Real cosine = 1 - height, sine = std::sqrt(height * (2 - height));
    const auto turn = sine_cosine_of_turn(place.y);
    const Vec3 direction = normalize(orthonormal_basis(apart / distance)
                                         .to_world({sine * turn.cosine, sine * turn.sine, cosine}));
    // The smaller solution of t^2 - 2 d cosine t + d^2 - r^2 = 0. A quarter of the discriminant,
    // divided by d^2, is the difference of the squared sines:
    // whole (2 - whole) - height (2 - height).
    const Real root = std::sqrt((whole - height) * (2 - whole - height));
    const Real near = (distance - radius) * ((distance + radius) / distance) / (cosine + root);
    return LightSample{direction, near, 1 / (2 * pi * whole)};
}

}  // namespace rt
