#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/length.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

inline Hit surface_hit(const Sphere& sphere, const Ray& ray, Real t) {
    Hit hit;
    hit.t = t;
    // From the center, not from the scene's origin: no digits are lost to a far place.
    const Vec3 outward = (ray.origin - sphere.center) + t * ray.direction;
    // Seen from so far away that rounding swallows the whole sphere, it is hit head on.
    hit.normal = outward == Vec3{} ? normalize(-ray.direction) : outward / sphere.radius;
    hit.front = dot(ray.direction, hit.normal) <= 0;
    hit.point = sphere.center + sphere.radius * hit.normal;
    // One rounding of each coordinate of the point. What hangs on the radius: 3.5 roundings of the
    // normal's length, 1 of the product and 7 in hit_sphere, when a ray leaves from here. The rest
    // covers the bound's own rounding.
    hit.point_error = rounding_bound(1) * dot(abs(hit.point), abs(hit.normal)) +
                      rounding_bound(16) * sphere.radius;
    return hit;
}

}  // namespace rt
