#pragma once
#include <optional>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>
#include <rt/uniform_direction.hpp>

namespace rt {

// Exercise 08.3. 1 - cos a, where a is the angle, as seen from a point outside a light, between the
// light's center and its rim. `distance` is the distance of the center from this point: 0 < radius
// < distance.
// Star: accurate to 7 units in the last place, even for small and far lights, if the result is at
// least std::numeric_limits<Real>::min(), because smaller numbers have fewer digits.
inline Real cone_height(Real radius, Real distance) {
    return rt::todo("08.3", radius, distance);
}

// Exercise 08.3. The probability density, per solid angle, with which sample_light chooses a
// direction: 1 / (2 pi cone_height). Inside the light or on its surface, it is 1 / (4 pi).
// Star: it is 0 if cone_height is less than std::numeric_limits<Real>::min(), because 1 /
// cone_height may then be infinite: such a light is not sampled.
inline Real light_density(const Sphere& light, Vec3 from) {
    return rt::todo("08.3", light, from);
}

// Exercise 08.3. A direction of length 1 to a sphere that shines, the distance to its surface in
// this direction, and light_density. `place` is a sample point, 0 <= x, y < 1. x says how far the
// direction is from the center (0) toward the rim (1), as a fraction of cone_height; y is the
// fraction of a turn around the center, counted from any direction. If the point is not outside the
// light, you may return none.
// Star: if the point is inside or on the surface, all directions must be equally likely.
// Returns none where light_density is 0. The direction's length is accurate to 5 epsilon. The point
// at the returned distance lies within rounding_bound(60) * (d + r) of the surface, where d is the
// distance of the center and r the radius. For x = 0 the distance is d - r, with a relative error
// of at most rounding_bound(30).
// Source: Wang, "Physically correct direct lighting for distribution ray tracing", Graphics Gems
// III, 1992.
inline std::optional<LightSample> sample_light(const Sphere& light, Vec3 from, Vec2 place) {
    return rt::todo("08.3", light, from, place);
}

}  // namespace rt
