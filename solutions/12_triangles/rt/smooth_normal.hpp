#pragma once
#include <array>
#include <rt/above_horizon.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/reflect.hpp>
#include <rt/triangle.hpp>

namespace rt {

// The normal of the curved surface that the triangle stands for: the normals of the three corners,
// interpolated with the weights 1 - u - v, u and v, and scaled to length 1. If the result is not on
// the side of `flat`, the triangle's own normal, it is turned around; if the three normals cancel,
// the result is `flat`.
inline Vec3 smooth_normal(const std::array<Vec3, 3>& normals, Real u, Real v, Vec3 flat) {
    const Vec3 sum = (1 - u - v) * normals[0] + u * normals[1] + v * normals[2];
    if (sum == Vec3{}) return flat;
    const Vec3 normal = normalize(sum);
    return dot(normal, flat) < 0 ? -normal : normal;
}

// The normal to use for a mirror: `smooth` itself, if a mirror with this normal reflects `incoming`
// to the side of the triangle that the light came from. Otherwise, `smooth` is bent until the
// mirror direction runs along the triangle. All vectors have length 1; `flat` is on the side of
// `smooth`. If `incoming` runs along the triangle itself, there is no such normal, and the result
// is `flat`, unless `smooth` will do.
inline Vec3 bent_normal(Vec3 smooth, Vec3 flat, Vec3 incoming) {
    const Real side = dot(incoming, flat) > 0 ? Real(-1) : Real(1);  // where the light comes from
    const Vec3 up = side * flat, mirrored = reflect(incoming, smooth);
    const Real height = dot(mirrored, up);
    if (height >= 0) return smooth;
    const Vec3 sunk = mirrored - height * up;
    if (sunk == Vec3{}) return flat;
    const Vec3 bent = normalize(sunk) - incoming;  // halfway between sunk and the way back
    return dot(bent, up) > 0 ? side * normalize(bent) : flat;
}

// The vector from a point of the triangle, with the weights u and v of b and c, to where light
// leaves that runs over the triangle's horizon. At each corner, the plane across the corner's
// normal touches the curved surface. The result is the mean of the ways from the point straight up
// to these planes, with the weights of the corners; to a plane that is not above the point, there
// is no way. The normals have length 1 and are all on the side that the light comes from. Source:
// Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, chapter 4, 2021.
inline Vec3 lift(const Triangle& triangle, const std::array<Vec3, 3>& normals, Real u, Real v) {
    const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const Vec3 from_a = u * ab + v * ac;
    const std::array<Vec3, 3> from{from_a, from_a - ab, from_a - ac};
    const std::array<Real, 3> weights{1 - u - v, u, v};
    Vec3 sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const Real height = dot(from[k], normals[k]);
        if (height < 0) sum -= weights[k] * height * normals[k];
    }
    return sum;
}

// Corrects the direction of scattered light, which a material has chosen with the smooth normal:
// reflected light stays above the triangle, and refracted light goes below it. A direction on the
// wrong side is mirrored at the triangle. All vectors have length 1.
inline Vec3 keep_side(Vec3 direction, Vec3 smooth, Vec3 flat) {
    const Vec3 side = dot(direction, smooth) < 0 ? -flat : flat;
    return dot(direction, side) > 0 ? direction : above_horizon(direction, side);
}

}  // namespace rt
