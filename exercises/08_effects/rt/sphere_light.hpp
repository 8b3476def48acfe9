#pragma once
#include <optional>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.3. 1 - cos a, where a is the angle between the direction to a light's middle and to
// its rim, as seen from a point outside of it: 0 < radius < distance.
// Star: within 7 units in the last place, even for small and far lights, if the result is at least
// std::numeric_limits<Real>::min(): numbers below that have fewer digits.
inline Real cone_height(Real radius, Real distance) {
    return rt::todo("08.3", radius, distance);
}

// Exercise 08.3. The probability density, per solid angle, with which sample_light chooses a
// direction: evenly among those in which the light is seen, so 1 / (2 pi cone_height). Seen from
// inside the light, or from a point on its surface, it is 1 / (4 pi): all directions are chosen.
// Star: it is 0 if cone_height is less than std::numeric_limits<Real>::min(), because
// 1 / cone_height may then be infinite: such a light is not sampled.
inline Real light_density(const Sphere& light, Vec3 from) {
    return rt::todo("08.3", light, from);
}

// Exercise 08.3. A direction to a sphere that shines, of length 1, the distance to the sphere's
// surface along it, and light_density. None if that density is 0. `place` is a sample
// point of the unit square, 0 <= x, y < 1: x says how far the direction is from the middle (0)
// toward the rim (1), spread evenly over the cap's height; y is the share of a turn around the
// middle, starting wherever you like, in either direction.
// Source: Wang, "Physically correct direct lighting for distribution ray tracing", Graphics Gems
// III, 1992.
// Star: from inside, or from a point on the surface, any way to make all directions equally likely
// will do. The length is 1 within 5 epsilon. The distance leads to the surface within
// rounding_bound(60) * (d + r), where d is that of the middle and r the radius; for x = 0 it is
// d - r within rounding_bound(30) of itself.
inline std::optional<LightSample> sample_light(const Sphere& light, Vec3 from, Vec2 place) {
    return rt::todo("08.3", light, from, place);
}

// Exercise 08.3. The weight of a way to find light that chose a direction with this density, if the
// other way would have chosen it with density `other`: density^2 / (density^2 + other^2). Both are
// 0 or more, finite, and not both 0. Source: the power heuristic of Veach and Guibas, "Optimally
// combining sampling techniques for Monte Carlo rendering", SIGGRAPH 1995.
// Star: no square may overflow, and nothing may become 0 / 0. Off by at most 8 epsilon, which may
// be all of a small weight.
inline Real shared_weight(Real density, Real other) {
    return rt::todo("08.3", density, other);
}

}  // namespace rt
