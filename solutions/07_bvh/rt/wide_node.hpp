#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <rt/box.hpp>
#include <rt/compiler.hpp>
#include <rt/wide.hpp>
#include <rt/wide_ray.hpp>
#include <type_traits>

namespace rt {

// A node with up to eight children (given). Number is the type of the boxes' coordinates, which may
// be less precise than Real: the boxes are grown for that.
template <class Number>
struct alignas(64) WideNode {
    // The low planes of all children along x, y and z, then the high ones.
    std::array<std::array<Lanes<Number>, 3>, 2> planes;
    Lanes<std::int32_t> child;  // a node; or ~leaf, which is negative

    void set(std::size_t i, const Box& box, std::int32_t of) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            planes[0][k][i] = static_cast<Number>(along(box.low, axis));
            planes[1][k][i] = static_cast<Number>(along(box.high, axis));
        }
        child[i] = of;
    }
};

// Where a ray enters a child's box, and the child's lane, in one whole number: the bits of floating
// numbers from 0 on are in the same order as the numbers, and the last ones hold the lane.
template <class Number>
using KeyOf = std::conditional_t<sizeof(Number) == 4, std::int32_t, std::int64_t>;

template <class Number>
KeyOf<Number> key_of(Number t) {
    return std::bit_cast<KeyOf<Number>>(t);
}
// The largest key of a box that is entered at t or before.
template <class Number>
KeyOf<Number> last_key(Number t) {
    return key_of(t) | static_cast<KeyOf<Number>>(lanes - 1);
}
template <class Key>
std::size_t lane_of(Key key) {
    return static_cast<std::size_t>(key) % lanes;
}

template <class Number>
struct BoxesHit {
    Lanes<KeyOf<Number>> keys;  // of the children that are met
    KeyOf<Number> nearest;      // the smallest of them
    std::uint32_t met;          // bit i is set where child i is met
};

// Which children's boxes the ray meets between min and max.
template <class Number>
RT_INLINED BoxesHit<Number> hit_boxes(const WideNode<Number>& node, const WideRay<Number>& ray,
                                      Number min, Number max) {
    using Key = KeyOf<Number>;
    constexpr Key none = std::numeric_limits<Key>::max();
    const auto &near = ray.near_origin, &far = ray.far_origin, &inverse = ray.inverse;
    const auto first = [&](std::size_t k) { return node.planes[ray.near[k]][k].data(); };
    const auto second = [&](std::size_t k) { return node.planes[1 - ray.near[k]][k].data(); };
    const Number *const first_x = first(0), *const first_y = first(1), *const first_z = first(2),
                        *const second_x = second(0), *const second_y = second(1),
                        *const second_z = second(2);
    // A t that is not a number fails the comparison, and its plane does not count.
    const auto later = [](Number t, Number than) { return t > than ? t : than; };
    const auto earlier = [](Number t, Number than) { return t < than ? t : than; };

    BoxesHit<Number> hit;
    Key* const keys = hit.keys.data();
    Key nearest = none;
    std::uint32_t met = 0;
#pragma omp simd reduction(min : nearest) reduction(| : met)
    for (std::size_t i = 0; i < lanes; ++i) {
        const Number in_x = later((first_x[i] - near[0]) * inverse[0], min);
        const Number in_y = later((first_y[i] - near[1]) * inverse[1], in_x);
        const Number in = later((first_z[i] - near[2]) * inverse[2], in_y);
        const Number out_x = earlier((second_x[i] - far[0]) * inverse[0], max);
        const Number out_y = earlier((second_y[i] - far[1]) * inverse[1], out_x);
        const Number out = earlier((second_z[i] - far[2]) * inverse[2], out_y);
        const Key entry = key_of(later(in, 0)) & -static_cast<Key>(lanes);
        const Key key = in <= out ? entry | static_cast<Key>(i) : none;
        keys[i] = key;
        nearest = key < nearest ? key : nearest;
        met |= in <= out ? 1u << i : 0;
    }
    hit.nearest = nearest;
    hit.met = met;
    return hit;
}

}  // namespace rt
