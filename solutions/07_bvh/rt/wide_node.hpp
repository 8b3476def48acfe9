#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <rt/slab_ray.hpp>
#include <rt/sphere.hpp>

namespace rt {

// Eight boxes or eight spheres side by side, tested at once (given). Each loop below does the same
// to all eight and has no branch: the compiler makes a few wide instructions of it (SIMD: single
// instruction, multiple data).
inline constexpr std::size_t lanes = 8;
template <class T>
using Lanes = std::array<T, lanes>;

// Bit i is set where condition[i] is true.
inline unsigned bits_of(const Lanes<std::int32_t>& condition) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < lanes; ++i)
        bits |= static_cast<std::uint32_t>(-condition[i]) & (1u << i);
    return bits;
}

// A node with up to eight children. Number is the type of the boxes' coordinates, which may be less
// precise than Real: the boxes are grown for that.
template <class Number>
struct alignas(64) WideNode {
    std::array<Lanes<Number>, 3> low, high;  // along x, y and z
    Lanes<std::int32_t> child;               // a node; or ~leaf, which is negative
};

// A ray for WideNode: its direction scaled so that its largest component is 1 or -1.
template <class Number>
struct WideRay {
    std::array<Number, 3> near_origin, far_origin, inverse;
    std::array<bool, 3> forward;
    Real scale;  // what t is multiplied by

    explicit WideRay(const Ray& ray) : scale{max_component(ray.direction)} {
        constexpr Real slab = 8 * static_cast<Real>(std::numeric_limits<Number>::epsilon());
        const Real margin = std::max(hit_margin, slab) * max_component(ray.origin);
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const Real d = along(ray.direction, axis), origin = along(ray.origin, axis);
            forward[k] = !std::signbit(d);
            inverse[k] = static_cast<Number>(scale / d);
            // The nearer plane is moved towards the ray, and the farther one away from it.
            near_origin[k] = static_cast<Number>(forward[k] ? origin + margin : origin - margin);
            far_origin[k] = static_cast<Number>(forward[k] ? origin - margin : origin + margin);
        }
    }
};

// Which children's boxes the ray meets between min and max, and where it enters each.
template <class Number>
unsigned hit_boxes(const WideNode<Number>& node, const WideRay<Number>& ray, Number min, Number max,
                   Lanes<Number>& enters) {
    Lanes<Number> near, far;
    for (std::size_t i = 0; i < lanes; ++i) near[i] = min;
    for (std::size_t i = 0; i < lanes; ++i) far[i] = max;
    for (std::size_t k = 0; k < 3; ++k) {
        const Lanes<Number>& first = ray.forward[k] ? node.low[k] : node.high[k];
        const Lanes<Number>& second = ray.forward[k] ? node.high[k] : node.low[k];
        const Number near_origin = ray.near_origin[k], far_origin = ray.far_origin[k];
        const Number inverse = ray.inverse[k];
        for (std::size_t i = 0; i < lanes; ++i) {
            const Number t = (first[i] - near_origin) * inverse;
            near[i] = near[i] < t ? t : near[i];  // not for a t that is not a number
        }
        for (std::size_t i = 0; i < lanes; ++i) {
            const Number t = (second[i] - far_origin) * inverse;
            far[i] = t < far[i] ? t : far[i];
        }
    }
    Lanes<std::int32_t> met;
    for (std::size_t i = 0; i < lanes; ++i) met[i] = near[i] <= far[i];
    enters = near;
    return bits_of(met);
}

// A leaf with up to eight spheres. Places that are not used hold zeros.
struct alignas(64) WideLeaf {
    Lanes<Real> x{}, y{}, z{}, radius{};
    Lanes<std::int32_t> number{};
    std::int32_t count = 0;

    Sphere sphere(std::size_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
};

// Which spheres of a leaf the line of the ray meets. It computes the discriminant as hit_sphere
// does, by the same operations in the same order, so that both agree to the last bit.
inline unsigned may_hit(const WideLeaf& leaf, const Ray& ray) {
    const Vec3 o = ray.origin, d = ray.direction;
    const Real a = d.x * d.x + d.y * d.y + d.z * d.z;
    Lanes<std::int32_t> met;
    for (std::size_t i = 0; i < lanes; ++i) {
        const Real fx = o.x - leaf.x[i], fy = o.y - leaf.y[i], fz = o.z - leaf.z[i];
        const Real mx = fy * d.z - fz * d.y, my = fz * d.x - fx * d.z, mz = fx * d.y - fy * d.x;
        const Real quarter =
            a * (leaf.radius[i] * leaf.radius[i]) - (mx * mx + my * my + mz * mz);
        met[i] = quarter >= 0;
    }
    return bits_of(met) & ((1u << leaf.count) - 1u);
}

}  // namespace rt
