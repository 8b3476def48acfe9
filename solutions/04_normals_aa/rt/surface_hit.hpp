#pragma once
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/length.hpp>
#include <rt/ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

// Everything about the point where a ray meets a sphere at t: the point, moved onto the surface;
// the outward normal; the side that was hit; and how far off the surface rounding may have left the
// point. t must be what hit_sphere returned for this sphere and ray. The side is right if the
// cosine of the angle between direction and normal, without its sign, is above
// 4 sqrt(epsilon (1 + distance / radius)), where the distance is measured from the ray's origin to
// the center. If that distance exceeds 1 / (16 epsilon) radii, the side is a guess.
inline Hit surface_hit(const Sphere& sphere, const Ray& ray, Real t) {
    Hit hit;
    hit.t = t;
    // From the center, not from the scene's origin: a sphere far from the origin loses no digits.
    const Vec3 outward = (ray.origin - sphere.center) + t * ray.direction;
    // If the sphere is so far away that rounding swallows all of it, it counts as hit head on.
    hit.normal = outward == Vec3{} ? normalize(-ray.direction) : normalize(outward);
    hit.front = dot(ray.direction, hit.normal) <= 0;
    hit.point = sphere.center + sphere.radius * hit.normal;
    // The bound allows for one rounding of each coordinate of the point. The rest is in proportion
    // to the radius: 3.5 roundings for the normal's length, 1 for the product, 7.2 for hit_sphere
    // when a ray leaves from here, and some for the rounding of the bound itself.
    hit.point_error = rounding_bound(1) * dot(abs(hit.point), abs(hit.normal)) +
                      rounding_bound(16) * sphere.radius;
    return hit;
}

}  // namespace rt
