#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rt/compiler.hpp>
#include <rt/sphere_list.hpp>
#include <rt/wide.hpp>

namespace rt {

// A leaf with up to eight spheres and their materials: all that a hit needs (given).
struct alignas(64) WideLeaf {
    static constexpr Real nothing = std::numeric_limits<Real>::quiet_NaN();

    // Places that are not used have a radius that is not a number: no ray hits that.
    Lanes<Real> x{}, y{}, z{}, radius;
    Lanes<std::int32_t> tag{};  // the sphere's number in the scene, times eight, and its place here
    Lanes<std::int32_t> material{};

    WideLeaf() { radius.fill(nothing); }

    // Numbers go up to 2^28.
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

// Tries the spheres of a leaf between min and best.t; whether best has changed. It is hit_sphere
// eight times at once: the same operations in the same order, so that every lane has its result to
// the last bit. Of equally near spheres the one with the highest number counts.
RT_NOT_INLINED inline bool hit_leaf(const WideLeaf& leaf, const Ray& ray, Real min, WideHit& best) {
    const Vec3 o = ray.origin, d = ray.direction;
    const Real a = d.x * d.x + d.y * d.y + d.z * d.z, max = best.t;
    const Real *const x = leaf.x.data(), *const y = leaf.y.data(), *const z = leaf.z.data(),
                      *const radius = leaf.radius.data();
    const std::int32_t* const tags = leaf.tag.data();

    Lanes<Real> quarters, all;
    Real *const quarter = quarters.data(), *const nearer = all.data();
    int any = 0;
#pragma omp simd reduction(| : any)
    for (std::size_t i = 0; i < lanes; ++i) {
        const Real fx = o.x - x[i], fy = o.y - y[i], fz = o.z - z[i];
        const Real mx = fy * d.z - fz * d.y, my = fz * d.x - fx * d.z, mz = fx * d.y - fy * d.x;
        quarter[i] = a * (radius[i] * radius[i]) - (mx * mx + my * my + mz * mz);
        any |= quarter[i] >= 0;
    }
    if (!(any && a > 0)) return false;  // most leaves are done here

    Real nearest = max;
#pragma omp simd reduction(min : nearest)
    for (std::size_t i = 0; i < lanes; ++i) {
        const Real fx = o.x - x[i], fy = o.y - y[i], fz = o.z - z[i];
        const Real b = fx * d.x + fy * d.y + fz * d.z;
        const Real c = fx * fx + fy * fy + fz * fz - radius[i] * radius[i];
        const Real q = -(2 * b + std::copysign(std::sqrt(4 * quarter[i]), 2 * b)) / 2;
        const Real one = q == 0 ? Real(0) : c / q, other = q == 0 ? Real(0) : q / a;
        const Real low = one < other ? one : other, high = one < other ? other : one;
        // Every comparison with the root of a negative number is false.
        const Real second = ((min <= high) & (high <= max)) ? high : WideLeaf::nothing;
        const Real t = ((min <= low) & (low <= max)) ? low : second;
        nearer[i] = t;
        nearest = t < nearest ? t : nearest;
    }
    std::int32_t tag = -1;
#pragma omp simd reduction(max : tag)
    for (std::size_t i = 0; i < lanes; ++i) {
        const std::int32_t its = nearer[i] == nearest ? tags[i] : -1;
        tag = its > tag ? its : tag;
    }
    // At best.t itself the leaf may hold the higher number, or the lower one.
    if (tag < 0 || (nearest == max && tag < best.tag)) return false;
    best = {nearest, tag};
    return true;
}

}  // namespace rt
