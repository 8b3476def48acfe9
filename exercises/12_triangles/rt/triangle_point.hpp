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
// has returned for them: t; the point, by the weights of the corners; the normal, from which a, b
// and c go around counterclockwise; whether the ray came from there (front); the material; and
// kept_as_light(number) for `light`. point_error says how far off the plane rounding may have left
// the point.
// Star: a ray that leave_surface starts from here does not meet the triangle again, be it far from
// the scene's origin or as thin as a needle; and the error is at most 40 epsilon times (the largest
// coordinate of the point + that of an edge).
// Source of the idea: Pharr, Jakob and Humphreys, "Physically Based Rendering", section 6.8.
inline Hit surface_hit(const SceneTriangle& triangle, const Ray& ray, Real t) {
    return rt::todo("12.4", triangle, ray, t);
}

}  // namespace rt
