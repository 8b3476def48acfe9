#pragma once
#include <algorithm>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/length.hpp>
#include <rt/triangle_number.hpp>

namespace rt {

// Everything about the point where a ray meets a triangle at t, which must be the t that
// hit_triangle returned: the point, by the weights of the corners; the triangle's normal; the side
// that the ray comes from; and point_error, how far off the plane the point may be.
inline Hit surface_hit(const SceneTriangle& triangle, const Ray& ray, Real t) {
    const auto& [a, b, c] = triangle.shape;
    const Vec3 ab = b - a, ac = c - a;
    const TriangleHit met = hit_triangle(triangle.shape, ray, {t, t}).value_or(TriangleHit{});
    Hit hit;
    hit.t = t;
    // Starts from a corner, not from the scene's origin, so that a triangle far from the origin
    // loses no digits.
    hit.point = a + (met.u * ab + met.v * ac);
    hit.normal = normalize(cross(ab, ac));
    hit.front = dot(ray.direction, hit.normal) <= 0;
    // The first term is one rounding of each coordinate of the point. The second term is in
    // proportion to the triangle's size: it covers the rounding in the two steps from the corner,
    // and the rounding in hit_triangle when the next ray starts here.
    const Real size = std::max(max_component(ab), max_component(ac));
    hit.point_error =
        rounding_bound(1) * dot(abs(hit.point), abs(hit.normal)) + rounding_bound(40) * size;
    hit.material = triangle.material;
    hit.light = kept_as_light(triangle.number);
    return hit;
}

}  // namespace rt
