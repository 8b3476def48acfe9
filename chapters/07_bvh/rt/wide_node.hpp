#pragma once
#include <array>
#include <rt/box.hpp>
#include <rt/vector_registers.hpp>
#include <rt/wide.hpp>
#include <rt/wide_child.hpp>
#include <rt/wide_ray.hpp>

namespace rt {

// A node with up to eight children (given). Number is the type of the boxes' coordinates. It may be
// less precise than Real: the boxes are grown to allow for that.
template <class Number>
struct alignas(64) WideNode {
    // The low planes of all children along x, y and z, then the high ones.
    std::array<std::array<Lanes<Number>, 3>, 2> planes;
    Lanes<WideChild> child;

    void set(std::size_t i, const Box& box, WideChild of) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            planes[0][k][i] = static_cast<Number>(along(box.low, axis));
            planes[1][k][i] = static_cast<Number>(along(box.high, axis));
        }
        child[i] = of;
    }
};

template <class Number>
struct BoxesHit {
    Lanes<Number> entry;  // where the ray enters the boxes of the children that are met
    unsigned met = 0;     // bit i is set if child i is met
};

// Which children's boxes the ray meets between min and max.
template <class Number>
RT_INLINED BoxesHit<Number> hit_boxes(const WideNode<Number>& node, const WideRay<Number>& ray,
                                      Number min, Number max) {
    BoxesHit<Number> hit;
    for (std::size_t first = 0; first < lanes; first += part_size<Number>) {
        Part<Number> in = min - Part<Number>{}, out = max - Part<Number>{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Part<Number> near = load<Part<Number>>(&node.planes[ray.near(k)][k][first]),
                               far = load<Part<Number>>(&node.planes[1 - ray.near(k)][k][first]);
            const Part<Number> entry = RT_FUSED(near, ray.inverse[k], ray.near_start[k]),
                               exit = RT_FUSED(far, ray.inverse[k], ray.far_start[k]);
            // A t that is NaN fails the comparison, and its plane does not count.
            in = entry > in ? entry : in;
            out = exit < out ? exit : out;
        }
        store(in, &hit.entry[first]);
        hit.met |= RT_VECTOR_BITS(in <= out) << first;
    }
    return hit;
}

}  // namespace rt
