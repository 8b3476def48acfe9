#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rt/compiler.hpp>
#include <rt/dot.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/sphere_list.hpp>
#include <rt/wide.hpp>

namespace rt {

// A tree may have this many spheres: a tag has to hold the number of each, times eight.
inline constexpr std::int64_t most_spheres = std::numeric_limits<std::int32_t>::max() / lanes;

// A leaf with up to eight spheres and their materials: all that a hit needs (given).
struct alignas(64) WideLeaf {
    static constexpr Real nothing = std::numeric_limits<Real>::quiet_NaN();

    // Places that are not used have a radius that is not a number: no ray hits that.
    Lanes<Real> x{}, y{}, z{}, radius;
    Lanes<std::int32_t> tag{};  // the sphere's number in the scene, times eight, and its place here
    Lanes<std::int32_t> material{};

    WideLeaf() { radius.fill(nothing); }

    // The number is less than most_spheres.
    void set(std::size_t i, const SceneSphere& sphere, int number) {
        x[i] = sphere.shape.center.x;
        y[i] = sphere.shape.center.y;
        z[i] = sphere.shape.center.z;
        radius[i] = sphere.shape.radius;
        tag[i] = number * static_cast<int>(lanes) + static_cast<int>(i);
        material[i] = sphere.material;
    }
    bool is_used(std::size_t i) const { return !std::isnan(radius[i]); }
    Sphere sphere(std::size_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
};

// The nearest hit so far.
struct WideHit {
    Real t = infinity;
    std::int32_t tag = -1;  // of the sphere that is hit there; -1 before any

    int number() const { return tag < 0 ? -1 : tag / static_cast<int>(lanes); }
    std::size_t place() const { return static_cast<std::size_t>(tag) % lanes; }
};

// Which spheres of a leaf the line of the ray meets: bit i for place i. It computes the
// discriminant as hit_sphere does, by the same operations in the same order, so that both agree to
// the last bit.
RT_NOT_INLINED inline unsigned may_hit(const WideLeaf& leaf, const Ray& ray) {
    const Vec3 o = ray.origin, d = ray.direction;
    const Real a = d.x * d.x + d.y * d.y + d.z * d.z;
    const Real *const x = leaf.x.data(), *const y = leaf.y.data(), *const z = leaf.z.data(),
                      *const radius = leaf.radius.data();
    std::uint32_t met = 0;
#pragma omp simd reduction(| : met)
    for (std::size_t i = 0; i < lanes; ++i) {
        const Real fx = o.x - x[i], fy = o.y - y[i], fz = o.z - z[i];
        const Real mx = fy * d.z - fz * d.y, my = fz * d.x - fx * d.z, mz = fx * d.y - fy * d.x;
        const Real quarter = a * (radius[i] * radius[i]) - (mx * mx + my * my + mz * mz);
        met |= quarter >= 0 ? 1u << i : 0;
    }
    return met;
}

// Whether all of the sphere lies behind the ray, if its line meets it: the ray starts outside, on
// the way from its center. Both solutions are then negative. Half of all that lines meet is behind.
inline bool is_behind(const Sphere& sphere, const Ray& ray) {
    const Vec3 f = ray.origin - sphere.center;
    return dot(f, ray.direction) > 0 && dot(f, f) > sphere.radius * sphere.radius;
}

// Tries the spheres of a leaf between min and best.t; whether best has changed. Of equally near
// spheres the one with the highest number counts.
RT_INLINED bool hit_leaf(const WideLeaf& leaf, const Ray& ray, Real min, WideHit& best) {
    bool changed = false;
    for (unsigned met = may_hit(leaf, ray); met; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        const Sphere sphere = leaf.sphere(i);
        if (min >= 0 && is_behind(sphere, ray)) continue;
        const auto t = hit_sphere(sphere, ray, {min, best.t});
        // At best.t itself the leaf may hold the higher number, or the lower one.
        if (!t || (*t == best.t && leaf.tag[i] < best.tag)) continue;
        best = {*t, leaf.tag[i]};
        changed = true;
    }
    return changed;
}

}  // namespace rt
