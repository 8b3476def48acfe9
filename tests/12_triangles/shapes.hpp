#pragma once
// Triangles, meshes and rays for the checkpoints of this chapter.

#include <rt/dot.hpp>
#include <rt/mesh.hpp>
#include <rt/triangle.hpp>

#include "random_inputs.hpp"
#include "statistics.hpp"

namespace checkpoint {

using rt::Ray;
using rt::Triangle;

inline Vec3 in_cube(rt::Rng& rng) {
    const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
    return {x, y, z};
}

inline ExactVec3 exact_normal(const Triangle& triangle) {
    const ExactVec3 a = exact_vector(triangle.a);
    return cross(exact_vector(triangle.b) - a, exact_vector(triangle.c) - a);
}

// How far a point is from the triangle's plane.
inline double off_plane(const Triangle& triangle, const ExactVec3& point) {
    const ExactVec3 normal = exact_normal(triangle);
    return std::abs((dot(point - exact_vector(triangle.a), normal) / exact_length(normal)).high);
}

// The largest coordinate of a corner as seen from a point.
inline Real reach_from(Vec3 from, const Triangle& triangle) {
    return std::max({rt::max_component(triangle.a - from), rt::max_component(triangle.b - from),
                     rt::max_component(triangle.c - from)});
}

// A triangle of size 1 or less whose sides and angles are not too different.
inline Triangle plain_triangle(rt::Rng& rng) {
    for (;;) {
        const Triangle triangle{in_cube(rng), in_cube(rng), in_cube(rng)};
        if (exact_length(exact_normal(triangle)).high > 0.5) return triangle;
    }
}

// The triangle enlarged, then moved.
inline Triangle placed(const Triangle& triangle, Real size, Vec3 by) {
    return {by + size * triangle.a, by + size * triangle.b, by + size * triangle.c};
}

inline Vec3 point_of(const Triangle& triangle, Real u, Real v) {
    return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
}

inline std::string text(const Triangle& triangle) {
    return "the triangle " + text(triangle.a) + ", " + text(triangle.b) + ", " + text(triangle.c);
}
inline std::string text(const Ray& ray) {
    return "the ray from " + text(ray.origin) + " along " + text(ray.direction);
}

// A closed surface around the origin: an octahedron whose triangles are each cut into four, again
// and again, with corners on the unit sphere. If rough, they are then moved in or out by up to a
// tenth.
inline rt::Mesh ball(int cuts, rt::Rng* rough = nullptr) {
    using rt::Corner;
    rt::Mesh mesh;
    mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const auto add = [](std::vector<std::array<Corner, 3>>& to, int a, int b, int c) {
        to.push_back({Corner{a}, Corner{b}, Corner{c}});
    };
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5}) {
                const bool even = (x + y + z) % 2 == 0;
                add(mesh.triangles, x, even ? y : z, even ? z : y);
            }
    for (; cuts > 0; --cuts) {
        std::vector<std::pair<std::pair<int, int>, int>> made;
        const auto middle = [&](int i, int j) {
            const std::pair<int, int> edge = std::minmax(i, j);
            for (const auto& [ends, point] : made)
                if (ends == edge) return point;
            const Vec3 sum =
                mesh.points[static_cast<std::size_t>(i)] + mesh.points[static_cast<std::size_t>(j)];
            mesh.points.push_back(sum / std::sqrt(rt::dot(sum, sum)));
            made.push_back({edge, static_cast<int>(mesh.points.size()) - 1});
            return made.back().second;
        };
        std::vector<std::array<Corner, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const int ab = middle(a.point, b.point), bc = middle(b.point, c.point),
                      ca = middle(c.point, a.point);
            add(finer, a.point, ab, ca);
            add(finer, ab, b.point, bc);
            add(finer, ca, bc, c.point);
            add(finer, ab, bc, ca);
        }
        mesh.triangles = finer;
    }
    if (rough)
        for (Vec3& point : mesh.points) point *= rough->uniform(real(0.9), real(1.1));
    return mesh;
}

inline std::vector<Triangle> shapes_of(const rt::Mesh& mesh) {
    std::vector<Triangle> shapes;
    const auto at = [&](const rt::Corner& corner) {
        return mesh.points[static_cast<std::size_t>(corner.point)];
    };
    for (const auto& [a, b, c] : mesh.triangles) shapes.push_back({at(a), at(b), at(c)});
    return shapes;
}

}  // namespace checkpoint
