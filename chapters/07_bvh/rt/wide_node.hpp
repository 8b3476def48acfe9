#pragma once
#include <array>
#include <rt/box.hpp>
#include <rt/box_pack.hpp>
#include <rt/hit_box.hpp>
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
    using Numbers = Part<Number>;
    BoxesHit<Number> hit;
    for (std::size_t first = 0; first < lanes; first += part_size<Number>) {
        const auto corner = [&](std::size_t side) -> Vec3Of<Numbers> {
            const auto& planes = node.planes[side];
            return {load<Numbers>(&planes[0][first]), load<Numbers>(&planes[1][first]),
                    load<Numbers>(&planes[2][first])};
        };
        // min - Numbers{} is a pack with min in every lane.
        const IntervalPack<Numbers> part =
            hit_box(BoxPack<Numbers>{corner(0), corner(1)}, ray,
                    IntervalPack<Numbers>{min - Numbers{}, max - Numbers{}});
        store(part.min, &hit.entry[first]);
        hit.met |= RT_VECTOR_BITS(part.min <= part.max) << first;
    }
    return hit;
}

}  // namespace rt
