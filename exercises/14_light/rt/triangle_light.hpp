#pragma once
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/todo.hpp>
#include <rt/triangle.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 14.1. The weights of the corners b (x) and c (y) at a point of a triangle. If the sample
// points `place`, 0 <= x, y < 1, are spread evenly over the square, so are the points over the
// triangle. place.x is the share of the area that lies nearer to corner a, in the smaller triangle
// that the line through the point along bc cuts off; place.y is the position along that line, from
// side ab (0) to side ac (1).
// Source: Turk, "Generating random points in triangles", Graphics Gems, 1990.
inline Vec2 even_weights(Vec2 place) {
    return rt::todo("14.1", place);
}

// The probability density, per solid angle as seen from `from`, of the direction to this point of
// the triangle, if all points of the triangle are equally likely: distance^2 / (area * cosine). The
// cosine is that of the angle between the direction and the triangle's normal; both sides of the
// triangle shine, so it counts without its sign.
// Star: the density is 0 if the triangle has no area, if `from` lies in its plane, or if the result
// is not a normal number (std::isnormal). Nothing overflows or underflows on the way, for lengths
// from 1e-15 to 1e15 in float, and from 1e-120 to 1e120 in double. Even if the triangle is seen
// edge-on and is far from the origin, 1 / density is within rounding_bound(60) * area / distance^2
// of the exact value, as long as `from` is no nearer than the triangle is large.
inline Real light_density(const Triangle& light, Vec3 from, Vec3 point) {
    return rt::todo("14.1", light, from, point);
}

// A direction of length 1 to a point of the triangle, the distance to it, and light_density. The
// point is the one that even_weights gives for `place`.
// Star: none where light_density is 0.
inline std::optional<LightSample> sample_light(const Triangle& light, Vec3 from, Vec2 place) {
    return rt::todo("14.1", light, from, place);
}

}  // namespace rt
