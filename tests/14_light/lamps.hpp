#pragma once
// What is known of triangles that shine, for the checkpoints of this chapter.

#include <rt/vec2.hpp>

#include "../12_triangles/shapes.hpp"

namespace checkpoint {

using rt::Vec2;

inline Vec3 point_of(const Triangle& triangle, Vec2 weights) {
    return point_of(triangle, weights.x, weights.y);
}

// 1 / density by its definition: area * |cosine| / distance^2, where the cosine is that of the
// direction to the triangle's plane.
inline Exact exact_solid_angle(const Triangle& triangle, Vec3 from, Vec3 point) {
    const ExactVec3 normal = exact_normal(triangle);
    const ExactVec3 way = exact_vector(point) - exact_vector(from);
    const Exact distance = exact_length(way);
    const Exact height = dot(exact_vector(triangle.a) - exact_vector(from), normal);
    const Exact size = height / (distance * distance * distance * Exact(2));
    return size.high < 0 ? -size : size;
}

inline std::string text(Vec2 v) {
    return '(' + text(v.x) + ", " + text(v.y) + ')';
}

}  // namespace checkpoint
