#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/light_sample.hpp>
#include <rt/triangle.hpp>
#include <rt/vec2.hpp>

namespace rt {

// The weights of the corners b (x) and c (y) at a point of a triangle. `place` is a sample point,
// 0 <= x, y < 1: x is the share of the triangle's area that lies nearer to corner a, between a and
// the line through the point along bc; y says how far along that line the point is, from side ab
// (0) to side ac (1). If places are spread evenly over the square, so are points over the triangle.
inline Vec2 even_weights(Vec2 place) {
    const Real from_a = std::sqrt(place.x);  // the smaller triangle's side, as a share of the whole
    return {from_a * (1 - place.y), from_a * place.y};
}

// The probability density, per solid angle as seen from `from`, with which sample_light chooses the
// direction to this point of the triangle: distance^2 / (area * cosine), where the cosine is that
// between the direction and the normal, on either side. 0 if the triangle has no area or is seen
// edge-on, or if the result is not a normal number. 1 / density is within rounding_bound(60) times
// area / distance^2 of the exact value, as long as `from` is no nearer than the triangle is large.
inline Real light_density(const Triangle& light, Vec3 from, Vec3 point) {
    Vec3 ab = light.b - light.a, ac = light.c - light.a;
    const Real size = std::max(max_component(ab), max_component(ac));
    if (!(size > 0)) return 0;
    // All lengths are measured in a unit of about this size, so that no product of two of them
    // overflows or underflows. A power of two changes no digit.
    const Real scale = std::ldexp(Real(1), -std::ilogb(size));
    ab *= scale;
    ac *= scale;
    const Vec3 normal = cross(ab, ac);  // its length is twice the area
    // How far `from` is from the triangle's plane, times the length of the normal. A corner says
    // this better than the point, which has been rounded.
    const Real height = std::abs(dot(normal, scale * (light.a - from)));
    const Real distance = scale * length(point - from);
    const Real density = 2 * distance * (distance * (distance / height));
    return std::isnormal(density) ? density : 0;
}

// A direction to a random point of a triangle that shines: all points are equally likely. None if
// light_density is 0 there. `place` is as for even_weights.
inline std::optional<LightSample> sample_light(const Triangle& light, Vec3 from, Vec2 place) {
    const Vec2 weight = even_weights(place);
    const Vec3 point = light.a + (weight.x * (light.b - light.a) + weight.y * (light.c - light.a));
    const Real density = light_density(light, from, point);
    if (!(density > 0)) return {};
    return LightSample{normalize(point - from), length(point - from), density};
}

}  // namespace rt
