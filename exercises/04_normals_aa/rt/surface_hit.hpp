#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/length.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.1. Everything about the point where a ray meets a sphere at t, in the members of Hit
// (see <rt/hit.hpp>; leave its material at 0): t as it is; the outward normal; the side that was
// hit, which is the front if the direction is against the normal; the point, moved onto the surface
// along the normal; and point_error, how far rounding may have left it off the surface:
// `rounding_bound(16) * (|P| + radius)`.
// Star: point_error is `u (|Px nx| + |Py ny| + |Pz nz|) + 16 u radius` with u = epsilon / 2. A ray
// at a right angle to the normal hits the front. If rounding makes origin + t * direction the
// center itself, the sphere counts as hit head on. The side must be right if the cosine of the
// angle between direction and normal, without its sign, is above 4 sqrt(epsilon (1 + distance /
// radius)), where distance is measured from the ray's origin to the center. If that distance
// exceeds 1 / (16 epsilon) radii, the side is a guess. Source of the idea: Pharr, Jakob and
// Humphreys, "Physically Based Rendering", section 6.8.
inline Hit surface_hit(const Sphere& sphere, const Ray& ray, Real t) {
    return rt::todo("04.1", sphere, ray, t);
}

}  // namespace rt
