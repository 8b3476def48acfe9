#pragma once
#include <algorithm>
#include <rt/bounds.hpp>
#include <span>
#include <vector>

namespace rt {

inline Real surface_area(const Box& box) {
    const Vec3 size = box.size();
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

inline int split_by_area(std::span<int> order, std::span<const Box> boxes, Real boxes_cost) {
    const int n = static_cast<int>(order.size());
    const auto sort_along = [&](int axis) {
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            return along(boxes[a].center(), axis) < along(boxes[b].center(), axis);
        });
    };
    std::vector<Real> areas(n);
    Box whole;
    for (const int id : order) whole = join(whole, boxes[id]);
    Real best_cost = static_cast<Real>(n) * surface_area(whole);
    int best_left = 0, best_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
        sort_along(axis);
        Box right;
        for (int k = n - 1; k >= 1; --k) {
            right = join(right, boxes[order[k]]);
            areas[k] = surface_area(right);
        }
        Box left;
        for (int k = 1; k < n; ++k) {
            left = join(left, boxes[order[k - 1]]);
            const Real cost = boxes_cost * surface_area(whole) +
                              static_cast<Real>(k) * surface_area(left) +
                              static_cast<Real>(n - k) * areas[k];
            if (cost < best_cost) {
                best_cost = cost;
                best_left = k;
                best_axis = axis;
            }
        }
    }
    sort_along(best_axis);
    return best_left;
}

}  // namespace rt
