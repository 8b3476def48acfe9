#pragma once
#include <algorithm>
#include <rt/bounds.hpp>
#include <rt/box.hpp>
#include <span>
#include <vector>

namespace rt {

// The area of a box's six faces; 0 for the empty box.
inline Real surface_area(const Box& box) {
    const Vec3 size = box.size();
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

// Sorts the IDs of spheres so that the best split is between the first k of them and the rest,
// and returns k, or 0 if no split is cheaper than a leaf. The cost of a split is the work to expect
// for a ray that meets the box around all these spheres: boxes_cost for testing the two children's
// boxes, and for each child 1 per sphere, times the probability that the ray meets the child. This
// probability is the area of the child's box over that of the whole box. Source: MacDonald and
// Booth, "Heuristics for ray tracing using space subdivision", 1990.
inline int split_by_area(std::span<int> order, std::span<const Box> boxes, Real boxes_cost) {
    const auto box_of = [&](std::size_t place) -> const Box& {
        return boxes[static_cast<std::size_t>(order[place])];
    };
    const auto sort_along = [&](int axis) {
        const auto middle = [&](int sphere) {
            return along(boxes[static_cast<std::size_t>(sphere)].center(), axis);
        };
        // Equal middles stay in the order of their IDs, so that sorting once more along the
        // best axis gives the very order whose cost was computed.
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            const Real of_a = middle(a), of_b = middle(b);
            return of_a != of_b ? of_a < of_b : a < b;
        });
    };
    const std::size_t count = order.size();
    if (count < 2) return 0;

    // All costs are multiplied by the area of the whole box, so nothing is divided.
    Box whole;
    for (std::size_t i = 0; i < count; ++i) whole = join(whole, box_of(i));
    const Real both_boxes = boxes_cost * surface_area(whole);
    Real best_cost = static_cast<Real>(count) * surface_area(whole);  // of a leaf
    std::size_t best_left = 0;
    int best_axis = 0;

    std::vector<Real> right_area(count);
    for (int axis = 0; axis < 3; ++axis) {
        sort_along(axis);
        Box right, left;
        for (std::size_t i = count; i-- > 1;) {
            right = join(right, box_of(i));
            right_area[i] = surface_area(right);
        }
        for (std::size_t k = 1; k < count; ++k) {
            left = join(left, box_of(k - 1));
            const Real cost = both_boxes + static_cast<Real>(k) * surface_area(left) +
                              static_cast<Real>(count - k) * right_area[k];
            if (cost < best_cost) {
                best_cost = cost;
                best_left = k;
                best_axis = axis;
            }
        }
    }
    if (best_left != 0 && best_axis != 2) sort_along(best_axis);
    return static_cast<int>(best_left);
}

}  // namespace rt
