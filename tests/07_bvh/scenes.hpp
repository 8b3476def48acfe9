#pragma once
// Scenes and rays that are hard for a tree, and the hit that counts: the linear list's.

#include <algorithm>
#include <cstring>
#include <rt/rng.hpp>
#include <rt/search.hpp>
#include <rt/sphere_list.hpp>
#include <string>
#include <vector>

#include "checkpoint.hpp"
#include "statistics.hpp"

namespace checkpoint {

using rt::Box;
using rt::Interval;
using rt::Ray;
using rt::SceneSphere;
using Spheres = std::vector<SceneSphere>;

struct NamedScene {
    std::string name;
    Spheres spheres;
};

inline void add(Spheres& spheres, Vec3 center, Real radius) {
    spheres.push_back({{center, radius}, static_cast<int>(spheres.size())});
}

inline Vec3 in_cube(rt::Rng& rng) {
    const Real x = rng.uniform(-1, 1), y = rng.uniform(-1, 1), z = rng.uniform(-1, 1);
    return {x, y, z};
}

// The same numbers from the smallest to the largest.
inline std::vector<int> from_smallest(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

// This many spheres in a cube from -1 to 1. For any number, about the same share of it is full.
inline Spheres random_spheres(int count, std::uint64_t seed = 1) {
    rt::Rng rng{seed, 7};
    Spheres spheres;
    const Real largest = Real(0.6) / std::cbrt(static_cast<Real>(count));
    for (int i = 0; i < count; ++i) {
        const Vec3 center = in_cube(rng);
        add(spheres, center, largest * rng.uniform(Real(0.1), 1));
    }
    return spheres;
}

inline std::vector<NamedScene> hard_scenes() {
    std::vector<NamedScene> scenes;
    const auto scene = [&](const char* name) -> Spheres& {
        scenes.push_back({name, {}});
        return scenes.back().spheres;
    };
    scenes.reserve(16);
    Spheres& coincident = scene("20 spheres in one place");
    for (int i = 0; i < 20; ++i) add(coincident, {Real(0.25), 0, 0}, Real(0.5));
    Spheres& nested = scene("20 spheres within each other");
    for (int i = 1; i <= 20; ++i) add(nested, {}, static_cast<Real>(i) / 20);
    Spheres& touching = scene("a lattice of touching spheres");
    for (int i = 0; i < 64; ++i)
        add(touching,
            Vec3{static_cast<Real>(i % 4), static_cast<Real>(i / 4 % 4),
                 static_cast<Real>(i / 16)} /
                    4 -
                Vec3{1, 1, 1} * Real(0.375),
            Real(0.125));
    Spheres& sizes = scene("huge beside tiny");
    add(sizes, {0, -1000, 0}, 1000);
    for (int i = 0; i < 40; ++i) {
        const Real radius = std::pow(Real(10), -static_cast<Real>(i % 7));
        add(sizes, {static_cast<Real>(i % 8) / 4 - 1, radius, static_cast<Real>(i / 8) / 4 - 1},
            radius);
    }
    Spheres& line = scene("50 spheres on one line");
    for (int i = 0; i < 50; ++i) add(line, {static_cast<Real>(i) / 25 - 1, 0, 0}, Real(0.02));
    Spheres& far = scene("far from the origin");
    rt::Rng rng{3, 3};
    for (int i = 0; i < 50; ++i) add(far, Vec3{1000, 0, -500} + in_cube(rng), Real(0.1));
    return scenes;
}

// Rays of all kinds for a scene: random ones, along axes, with zeros of both signs, in faces of the
// spheres' boxes, tangent, from inside, and from the surface.
inline Ray any_ray(const Spheres& spheres, rt::Rng& rng, int kind) {
    const Real zero = rng.uniform() < Real(0.5) ? Real(0) : -Real(0);
    const auto one = [&] { return rng.uniform() < Real(0.5) ? Real(1) : Real(-1); };
    const auto turn = [&](Vec3 v, int times) {
        for (int i = 0; i < times; ++i) v = {v.z, v.x, v.y};
        return v;
    };
    rt::Sphere aim{{0, 0, 0}, 1};
    if (!spheres.empty()) aim = spheres[rng() % spheres.size()].shape;
    const Vec3 c = aim.center;
    const Real r = aim.radius;
    const int axis = static_cast<int>(rng() % 3);
    const Vec3 anywhere = c + 3 * in_cube(rng);
    switch (kind % 8) {
        case 0:  // at a sphere, from anywhere
            return {anywhere, c + r * Real(1.1) * any_direction(rng) - anywhere};
        case 1:  // anywhere
            return {anywhere, any_direction(rng)};
        case 2:  // along an axis, with zeros of either sign
            return {anywhere, turn({one(), zero, -zero}, axis)};
        case 3: {  // along an axis, in the face of a sphere's box: tangent to the sphere
            const Vec3 side = turn({0, r, 0}, axis), back = turn({one(), 0, 0}, axis);
            return {c + side - 4 * r * back, turn({back.x + back.y + back.z, zero, zero}, axis)};
        }
        case 4: {  // in a plane of the axes
            const Vec3 d = turn({rng.uniform(-1, 1), rng.uniform(-1, 1), zero}, axis);
            return {c - 5 * r * d, d};
        }
        case 5:  // from inside a sphere
            return {c + Real(0.9) * r * rng.uniform() * any_direction(rng), any_direction(rng)};
        case 6: {  // from the surface, up to rounding, along the surface
            const Vec3 n = any_direction(rng), other = any_direction(rng);
            return {c + r * n, other - n * (other.x * n.x + other.y * n.y + other.z * n.z)};
        }
        default:  // through a corner of a sphere's box
            return {anywhere, c + Vec3{one() * r, one() * r, one() * r} - anywhere};
    }
}

// What the linear list finds.
struct Winner {
    int sphere = -1;
    Real t = 0;
};

inline Winner linear(const Spheres& spheres, const Ray& ray, Interval within) {
    Winner winner;
    for (std::size_t i = 0; i < spheres.size(); ++i)
        if (const auto t = rt::hit_sphere(spheres[i].shape, ray, within)) {
            winner = {static_cast<int>(i), *t};
            within.max = *t;
        }
    return winner;
}

inline bool same_bits(Real a, Real b) {
    return a == b && std::signbit(a) == std::signbit(b);
}

inline std::string text(const Winner& winner) {
    if (winner.sphere < 0) return "no hit";
    return "sphere " + std::to_string(winner.sphere) + " at t = " + text(winner.t);
}
inline std::string text(const Ray& ray) {
    return "ray from " + text(ray.origin) + " along " + text(ray.direction);
}
inline std::string text(const Box& box) {
    return "box from " + text(box.low) + " to " + text(box.high);
}

}  // namespace checkpoint
