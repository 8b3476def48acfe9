#pragma once
#include <algorithm>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/length.hpp>
#include <rt/todo.hpp>
#include <rt/triangle_number.hpp>

namespace rt {

// Exercise 12.4. Everything about the point where a ray meets a triangle at t, which hit_triangle
// has returned: t; the point; the normal, on the side from which a, b and c run counterclockwise;
// whether the ray came from that side (front); the material; kept_as_light(number) for `light`; and
// point_error, how far off the plane the point may be.
// Star: compute the point by the weights of the corners. A ray that leaves here, from the origin
// that leave_surface returns, does not meet the triangle again, even if the triangle is far from
// the scene's origin or as thin as a needle. point_error is at most 40 epsilon times the sum of the
// largest coordinate of the point and that of an edge. Source of the idea: Pharr, Jakob and
// Humphreys, "Physically Based Rendering", section 6.8.
inline Hit surface_hit(const SceneTriangle& triangle, const Ray& ray, Real t) {
    return rt::todo("12.4", triangle, ray, t);
}

}  // namespace rt
