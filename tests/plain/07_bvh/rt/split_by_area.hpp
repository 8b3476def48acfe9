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

inline int split_by_area(std::span<int> order, std::span<const Box> boxes) {
    const auto box = [&](int sphere) { return boxes[static_cast<std::size_t>(sphere)]; };
    const auto sort_along = [&](int axis) {
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            return along(box(a).center(), axis) < along(box(b).center(), axis);
        });
    };
    const std::size_t count = order.size();
    Box whole;
    for (const int sphere : order) whole = join(whole, box(sphere));
    Real best_cost = static_cast<Real>(count) * surface_area(whole);
    std::size_t best_left = 0;
    int best_axis = 0;
    std::vector<Real> right_area(count);
    for (int axis = 0; axis < 3; ++axis) {
        sort_along(axis);
        Box left, right;
        for (std::size_t i = count - 1; i > 0; --i) {
            right = join(right, box(order[i]));
            right_area[i] = surface_area(right);
        }
        for (std::size_t k = 1; k < count; ++k) {
            left = join(left, box(order[k - 1]));
            const Real cost = surface_area(whole) + static_cast<Real>(k) * surface_area(left) +
                              static_cast<Real>(count - k) * right_area[k];
            if (cost < best_cost) {
                best_cost = cost;
                best_left = k;
                best_axis = axis;
            }
        }
    }
    sort_along(best_axis);
    return static_cast<int>(best_left);
}

}  // namespace rt
