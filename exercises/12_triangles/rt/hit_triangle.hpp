#pragma once
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/interval.hpp>
#include <rt/sheared_ray.hpp>
#include <rt/todo.hpp>
#include <rt/triangle.hpp>

namespace rt {

// Exercise 12.1. The hit of a ray and a triangle, from either side, if its t lies within the
// interval (both ends count). In the result, u and v are the weights of the corners b and c: the
// point is (1 - u - v) a + u b + v c. Returns none if the ray misses the triangle or is parallel to
// it.
// Star: a ray through an edge that two triangles share hits exactly one of them if they lie on
// different sides of the edge as the ray sees it, and both or none if they lie on the same side (at
// an outline). A ray through a corner hits exactly one of the triangles if they lie all around it.
// Return none for a triangle without area, however it is turned, and for a ray that contains NaN.
// The point of the ray at t is off the triangle's plane by at most 16 epsilon times the largest
// coordinate of a corner as seen from the ray's origin, even for needles.
// Source: Möller and Trumbore, "Fast, minimum storage ray/triangle intersection", Journal of
// Graphics Tools 2(1), 1997; the star: Woop, Benthin and Wald, JCGT 2(1), 2013.
inline std::optional<TriangleHit> hit_triangle(const Triangle& triangle, const Ray& ray,
                                               Interval within) {
    return rt::todo("12.1", triangle, ray, within);
}

}  // namespace rt
