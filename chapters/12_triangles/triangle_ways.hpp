#pragma once
// Three tests for a ray and a triangle, for the study and for the program that counts leaks.

#include <numbers>
#include <optional>
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/hit_triangle.hpp>
#include <rt/mesh.hpp>
#include <rt/portable.hpp>

namespace triangles {

using namespace rt;

// The plain test of Möller and Trumbore: 12.1 without its star.
struct Plain {
    Triangle triangle;

    explicit Plain(const Triangle& t) : triangle{t} {}
    std::optional<Real> hit(const Ray& ray, Interval within) const {
        const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
        const auto cross_of = [](Vec3 p, Vec3 q) {
            return Vec3{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
        };
        const Vec3 across = cross_of(ray.direction, ac);
        const Real det = dot(ab, across);
        if (det == 0) return {};
        const Real inverse = 1 / det;
        const Vec3 from_a = ray.origin - triangle.a;
        const Real u = dot(from_a, across) * inverse;
        if (!(u >= 0 && u <= 1)) return {};
        const Vec3 turned = cross_of(from_a, ab);
        const Real v = dot(ray.direction, turned) * inverse;
        if (!(v >= 0 && u + v <= 1)) return {};
        const Real t = dot(ac, turned) * inverse;
        if (!within.contains(t)) return {};
        return t;
    }
};

// The watertight test: 12.1 with its star.
struct Watertight {
    Triangle triangle;

    explicit Watertight(const Triangle& t) : triangle{t} {}
    std::optional<Real> hit(const Ray& ray, Interval within) const {
        const auto found = hit_triangle(triangle, ray, within);
        if (!found) return {};
        return found->t;
    }
};

// The test with three planes that are computed in advance: the triangle's own plane, and two planes
// through edges, in which the weight of b or of c is 0. The test then takes 15 products and one
// division.
// Source: Havel and Herout, "Yet faster ray-triangle intersection", IEEE TVCG 16(3), 2010.
struct Planes {
    struct Plane {
        Vec3 normal;
        Real offset;
        Real above(Vec3 p) const { return dot(normal, p) + offset; }
    };
    Plane whole, of_b, of_c;

    explicit Planes(const Triangle& t) {
        const Vec3 ab = t.b - t.a, ac = t.c - t.a, normal = cross(ab, ac);
        const Real squared = dot(normal, normal);
        const auto through_a = [&](Vec3 n) { return Plane{n, -dot(n, t.a)}; };
        whole = through_a(normal);
        of_b = through_a(cross(ac, normal) / squared);
        of_c = through_a(cross(normal, ab) / squared);
    }
    std::optional<Real> hit(const Ray& ray, Interval within) const {
        const Real falls = dot(whole.normal, ray.direction);
        if (falls == 0) return {};
        const Real t = -whole.above(ray.origin) / falls;
        if (!within.contains(t)) return {};
        const Vec3 point = ray.origin + t * ray.direction;
        const Real u = of_b.above(point), v = of_c.above(point);
        if (!(u >= 0 && v >= 0 && u + v <= 1)) return {};
        return t;
    }
};

// A closed, convex surface around the origin: a ball of radius 1 with this many belts of triangles.
inline Mesh closed_ball(int belts) {
    Mesh mesh;
    const int around = 2 * belts;
    mesh.points = {{0, 1, 0}, {0, -1, 0}};
    for (int belt = 1; belt < belts; ++belt)
        for (int k = 0; k < around; ++k) {
            // Turned a little, so that no edge runs along an axis.
            const double down = std::numbers::pi * belt / belts,
                         turn = 2 * std::numbers::pi * (k + 0.37) / around;
            const double ring = rt::portable::sin(down);
            mesh.points.push_back({static_cast<Real>(ring * rt::portable::cos(turn)),
                                   static_cast<Real>(rt::portable::cos(down)),
                                   static_cast<Real>(ring * rt::portable::sin(turn))});
        }
    const auto at = [&](int belt, int k) {
        if (belt == 0) return Corner{0};
        if (belt == belts) return Corner{1};
        return Corner{2 + (belt - 1) * around + k % around};
    };
    for (int belt = 0; belt < belts; ++belt)
        for (int k = 0; k < around; ++k) {
            if (belt > 0) mesh.triangles.push_back({at(belt, k), at(belt, k + 1), at(belt + 1, k)});
            if (belt + 1 < belts)
                mesh.triangles.push_back({at(belt, k + 1), at(belt + 1, k + 1), at(belt + 1, k)});
        }
    return mesh;
}

}  // namespace triangles
