#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rt/box.hpp>
#include <rt/compiler.hpp>
#include <rt/slab_ray.hpp>
#include <rt/sphere_list.hpp>

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
RT_NOT_INLINED unsigned hit_boxes(const WideNode<Number>& node, const WideRay<Number>& ray,
                                  Number min, Number max, Lanes<Number>& enters) {
    const auto &near = ray.near_origin, &far = ray.far_origin, &inverse = ray.inverse;
    const Number* const first_x = (ray.forward[0] ? node.low : node.high)[0].data();
    const Number* const first_y = (ray.forward[1] ? node.low : node.high)[1].data();
    const Number* const first_z = (ray.forward[2] ? node.low : node.high)[2].data();
    const Number* const second_x = (ray.forward[0] ? node.high : node.low)[0].data();
    const Number* const second_y = (ray.forward[1] ? node.high : node.low)[1].data();
    const Number* const second_z = (ray.forward[2] ? node.high : node.low)[2].data();
    // A t that is not a number fails the comparison, and its plane does not count.
    const auto later = [](Number t, Number than) { return than < t ? t : than; };
    const auto earlier = [](Number t, Number than) { return t < than ? t : than; };
    Lanes<Number> in;
    Lanes<std::int32_t> met;
    for (std::size_t i = 0; i < lanes; ++i) {
        const Number in_x = later((first_x[i] - near[0]) * inverse[0], min);
        const Number in_y = later((first_y[i] - near[1]) * inverse[1], in_x);
        in[i] = later((first_z[i] - near[2]) * inverse[2], in_y);
        const Number out_x = earlier((second_x[i] - far[0]) * inverse[0], max);
        const Number out_y = earlier((second_y[i] - far[1]) * inverse[1], out_x);
        const Number out = earlier((second_z[i] - far[2]) * inverse[2], out_y);
        met[i] = in[i] <= out;
    }
    enters = in;
    return bits_of(met);
}

// A leaf with up to eight spheres, their numbers in the scene and their materials: all that a hit
// needs. Places that are not used have the number -1.
struct alignas(64) WideLeaf {
    Lanes<Real> x{}, y{}, z{}, radius{};
    Lanes<std::int32_t> number{-1, -1, -1, -1, -1, -1, -1, -1}, material{};

    void set(std::size_t i, const SceneSphere& sphere, int its_number) {
        x[i] = sphere.shape.center.x;
        y[i] = sphere.shape.center.y;
        z[i] = sphere.shape.center.z;
        radius[i] = sphere.shape.radius;
        number[i] = its_number;
        material[i] = sphere.material;
    }
    Sphere sphere(std::size_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
};

// Which spheres of a leaf the line of the ray meets. It computes the discriminant as hit_sphere
// does, by the same operations in the same order, so that both agree to the last bit.
RT_NOT_INLINED inline unsigned may_hit(const WideLeaf& leaf, const Ray& ray) {
    const Vec3 o = ray.origin, d = ray.direction;
    const Real a = d.x * d.x + d.y * d.y + d.z * d.z;
    Lanes<std::int32_t> met;
    for (std::size_t i = 0; i < lanes; ++i) {
        const Real fx = o.x - leaf.x[i], fy = o.y - leaf.y[i], fz = o.z - leaf.z[i];
        const Real mx = fy * d.z - fz * d.y, my = fz * d.x - fx * d.z, mz = fx * d.y - fy * d.x;
        const Real quarter = a * (leaf.radius[i] * leaf.radius[i]) - (mx * mx + my * my + mz * mz);
        met[i] = (quarter >= 0) & (leaf.number[i] >= 0);
    }
    return bits_of(met);
}

}  // namespace rt
