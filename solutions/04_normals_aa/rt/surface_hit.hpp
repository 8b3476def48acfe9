#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/length.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

// Everything about the point where a ray meets a sphere at t: the point, moved onto the surface;
// the outward normal; the side that was hit; and how far off the surface rounding may have left
// the point. t must be what hit_sphere returned for this sphere and ray. The side is right if the
// cosine of direction and normal is above 4 sqrt(epsilon (1 + distance / radius)), where the
// distance is that from the ray's origin to the center: from 1 / (16 epsilon) radii on, the side
// is a guess.
inline Hit surface_hit(const Sphere& sphere, const Ray& ray, Real t) {
    Hit hit;
    hit.t = t;
    // From the center, not from the scene's origin: a sphere far from the origin loses no digits.
    const Vec3 outward = (ray.origin - sphere.center) + t * ray.direction;
    // Seen from so far away that rounding swallows the whole sphere, it counts as hit head on.
    hit.normal = outward == Vec3{} ? normalize(-ray.direction) : normalize(outward);
    hit.front = dot(ray.direction, hit.normal) <= 0;
    hit.point = sphere.center + sphere.radius * hit.normal;
    // One rounding of each coordinate of the point. In proportion to the radius: 3.5 roundings of
    // the normal's length, 1 of the product and 7.2 in hit_sphere, when a ray leaves from here. The
    // rest covers the bound's own rounding.
    hit.point_error = rounding_bound(1) * dot(abs(hit.point), abs(hit.normal)) +
                      rounding_bound(16) * sphere.radius;
    return hit;
}

}  // namespace rt
