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
    const Vec3 outward = (ray.origin - sphere.center) + t * ray.direction;
    hit.normal = normalize(outward);
    hit.front = !(dot(ray.direction, hit.normal) > 0);
    hit.point = sphere.center + sphere.radius * hit.normal;
    hit.point_error = rounding_bound(16) * (length(hit.point) + sphere.radius);
    return hit;
}
}  // namespace rt
