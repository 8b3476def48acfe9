#pragma once
// Vectors in twice the precision of double, as references for what the checkpoints measure.

#include <rt/rng.hpp>
#include <rt/vec3.hpp>

#include "checkpoint.hpp"

namespace checkpoint {

inline ExactVec3 exact(Vec3 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
inline Exact exact(Real x) {
    return static_cast<double>(x);
}
inline Exact length(ExactVec3 v) {
    return sqrt(dot(v, v));
}
inline ExactVec3 unit(ExactVec3 v) {
    return (Exact(1) / length(v)) * v;
}
// The nearest vector that Real can hold. For a unit vector, its length is off by half an epsilon at
// most, since each component is off by at most that part of itself.
inline Vec3 rounded(ExactVec3 v) {
    return {static_cast<Real>(v.x.high), static_cast<Real>(v.y.high), static_cast<Real>(v.z.high)};
}

// A difference, in epsilon: units in the last place of 1.
inline double in_epsilon(Exact difference) {
    return std::abs(difference.high) / static_cast<double>(rt::epsilon);
}

// A random unit vector, each component the nearest that Real can hold.
inline Vec3 random_unit(rt::Rng& rng) {
    const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
    if (x * x + y * y + z * z > 1 || (x == 0 && y == 0 && z == 0)) return random_unit(rng);
    return rounded(unit(exact(Vec3{x, y, z})));
}

// A surface and light that arrives at it, from the normal's side.
struct Arrival {
    Vec3 incoming, normal;
};
inline Arrival random_arrival(rt::Rng& rng) {
    const Vec3 incoming = random_unit(rng), normal = random_unit(rng);
    return {dot(exact(incoming), exact(normal)).high > 0 ? -incoming : incoming, normal};
}

// Light that arrives in the xy plane at a floor, at this angle to the normal (0, 1, 0), in degrees.
inline Vec3 arriving_at_floor(double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return rounded(unit({std::sin(angle), -std::cos(angle), 0}));
}
inline constexpr Vec3 floor_normal{0, 1, 0};

}  // namespace checkpoint
