#pragma once
#include <array>
#include <rt/above_horizon.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/reflect.hpp>
#include <rt/todo.hpp>
#include <rt/triangle.hpp>

namespace rt {

// Exercise 12.3. The normals of the three corners, interpolated with the weights 1 - u - v, u and
// v, and scaled to length 1. `flat` is the triangle's own normal.
// Star: if the result is not on the side of `flat`, it is turned around; if the three normals
// cancel, the result is `flat`.
// Source: Phong, "Illumination for computer generated pictures", Comm. ACM 18, 1975.
inline Vec3 smooth_normal(const std::array<Vec3, 3>& normals, Real u, Real v, Vec3 flat) {
    return rt::todo("12.3", normals, u, v, flat);
}

// Exercise 12.3. The normal to use for a mirror: `smooth` itself, if a mirror with this normal
// reflects `incoming` to the side of the triangle that the light came from. All have length 1;
// `flat` is on the side of `smooth`.
// Star: otherwise, `smooth` is bent toward the light's side until the mirror direction runs along
// the triangle; the result is still on the side of `flat`. If `incoming` runs along the triangle
// itself, there is no such normal, and the result is `flat`, unless `smooth` will do.
// Source: the idea is in Keller et al., "The Iray light transport simulation and rendering system",
// 2017.
inline Vec3 bent_normal(Vec3 smooth, Vec3 flat, Vec3 incoming) {
    return rt::todo("12.3", smooth, flat, incoming);
}

// Exercise 12.3. The vector from a point of the triangle, with the weights u and v of b and c, to
// where light leaves that runs over the triangle's horizon. If the normals of the three corners are
// the triangle's own, it is the zero vector.
// Star: at each corner, the plane across the corner's normal touches the curved surface. The result
// is the mean of the ways from the point straight up to these planes, with the weights of the
// corners; to a plane that is not above the point, there is no way. The normals have length 1 and
// are all on the side that the light comes from.
// Source: Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, chapter 4, 2021.
inline Vec3 lift(const Triangle& triangle, const std::array<Vec3, 3>& normals, Real u, Real v) {
    return rt::todo("12.3", triangle, normals, u, v);
}

// Exercise 12.3. Corrects the direction of scattered light, which a material has chosen with the
// smooth normal. If the direction is above `smooth` (a positive dot product), it must be above
// `flat`, too; if it is below `smooth`, it must be below `flat`. A direction on the wrong side is
// mirrored at the triangle; any other direction is returned unchanged. All have length 1.
// Star: the computed dot product with `flat` is not 0, whatever was rounded.
inline Vec3 keep_side(Vec3 direction, Vec3 smooth, Vec3 flat) {
    return rt::todo("12.3", direction, smooth, flat);
}

}  // namespace rt
