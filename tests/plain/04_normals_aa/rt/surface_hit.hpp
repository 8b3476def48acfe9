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
    hit.normal = normalize(ray.origin + t * ray.direction - sphere.center);
    hit.front = dot(ray.direction, hit.normal) < 0;
    hit.point = sphere.center + sphere.radius * hit.normal;
    hit.point_error = rounding_bound(16) * (length(hit.point) + sphere.radius);
    return hit;
}

}  // namespace rt
