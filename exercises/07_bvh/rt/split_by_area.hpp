#pragma once
#include <algorithm>
#include <rt/bounds.hpp>
#include <rt/box.hpp>
#include <rt/todo.hpp>
#include <span>
#include <vector>

namespace rt {

// Exercise 07.5. The area of a box's six faces; 0 for the empty box.
inline Real surface_area(const Box& box) {
    return rt::todo("07.5", box);
}

// Exercise 07.5. Sorts the IDs of spheres so that the best split is between the first k and the
// rest, and returns k, or 0 if no split is cheaper than a leaf. The candidates are all splits of
// the spheres, sorted by their boxes' centers along x, y or z. The text gives the costs: that of a
// sphere's test is 1, that of both children's boxes is boxes_cost, 0 or more. `order` has at least
// one ID; ignore all other boxes.
// Star: equal centers may come in any order, but the final order must be the one whose cost you
// found to be the least. The time grows as n log(n) for n IDs. If the box around the spheres in
// `order` has area 0, nothing is cheaper than a leaf.
// Source: MacDonald and Booth, "Heuristics for ray tracing using space subdivision", 1990.
inline int split_by_area(std::span<int> order, std::span<const Box> boxes, Real boxes_cost) {
    rt::todo("07.5", order, boxes, boxes_cost);  // delete this line when you have filled the gaps
    const int n = static_cast<int>(order.size());
    const auto sort_along = [&](int axis) {
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            return along(boxes[a].center(), axis) < along(boxes[b].center(), axis);
        });
    };
    std::vector<Real> areas(n);  // areas[k]: the right part's area if k spheres are on the left
    // Gap 1: the cost of a leaf, which is the least so far.

    for (int axis = 0; axis < 3; ++axis) {
        sort_along(axis);
        Box right;
        for (int k = n - 1; k >= 1; --k) {
            right = join(right, boxes[order[k]]);
            areas[k] = surface_area(right);
        }
        // Gap 2: a box that grows from the left, the costs, and the cheapest split so far.
    }
    // Gap 3: the order of the best split, and its k.
    return 0;
}

}  // namespace rt
