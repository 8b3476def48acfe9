#pragma once
#include <algorithm>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/length.hpp>
#include <rt/triangle_number.hpp>

namespace rt {

inline Hit surface_hit(const SceneTriangle& triangle, const Ray& ray, Real t) {
    const auto& [a, b, c] = triangle.shape;
    Hit hit;
    hit.t = t;
    hit.point = ray.origin + t * ray.direction;
    hit.normal = normalize(cross(b - a, c - a));
    hit.front = dot(ray.direction, hit.normal) <= 0;
    const Real size = std::max(max_component(b - a), max_component(c - a));
    const Real largest = std::max({max_component(ray.origin), max_component(hit.point), size});
    hit.point_error = 100 * epsilon * largest;
    hit.material = triangle.material;
    hit.light = kept_as_light(triangle.number);
    return hit;
}

}  // namespace rt
