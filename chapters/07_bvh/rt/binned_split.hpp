#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <rt/bounds.hpp>
#include <rt/split_by_area.hpp>
#include <span>

namespace rt {

// The surface area heuristic without sorting (given): the spheres' middles fall into a few bins
// along each axis, and only splits between bins are tried. It takes linear time.
// Source: Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007.

// Twice the middle of a box: halving it would change no split.
inline Vec3 twice_middle(const Box& box) {
    return box.low + box.high;
}

inline constexpr std::size_t bins = 16;

// Bins of equal width along each axis, from the first middle to the last.
struct BinGrid {
    Box middles;
    Vec3 bins_per_length;  // 0 if all middles coincide

    BinGrid(std::span<const int> order, std::span<const Box> boxes) {
        for (const int number : order) {
            const Vec3 middle = twice_middle(boxes[static_cast<std::size_t>(number)]);
            middles = join(middles, {middle, middle});
        }
        const auto per_length = [](Real length) {
            const Real scale = static_cast<Real>(bins) / length;
            return scale < infinity ? scale : 0;
        };
        const Vec3 size = middles.size();
        bins_per_length = {per_length(size.x), per_length(size.y), per_length(size.z)};
    }
    std::size_t bin_of(const Box& box, int axis) const {
        const Real from_first = along(twice_middle(box), axis) - along(middles.low, axis);
        const auto bin = static_cast<unsigned>(from_first * along(bins_per_length, axis));
        return std::min<std::size_t>(bin, bins - 1);
    }
};

struct Bin {
    Box box;
    std::int32_t count = 0;

    void add(const Bin& other) {
        box = join(box, other.box);
        count += other.count;
    }
    Real cost() const { return surface_area(box) * static_cast<Real>(count); }
};

// The contents of the bins along each axis.
using Bins = std::array<std::array<Bin, bins>, 3>;

inline Bins fill_bins(std::span<const int> order, std::span<const Box> boxes, const BinGrid& grid) {
    Bins all{};
    for (const int number : order) {
        const Box& box = boxes[static_cast<std::size_t>(number)];
        for (int axis = 0; axis < 3; ++axis)
            all[static_cast<std::size_t>(axis)][grid.bin_of(box, axis)].add({box, 1});
    }
    return all;
}

// A split just before a bin. Bin 0 means no split.
struct BinSplit {
    int axis = 0;
    std::size_t bin = 0;
};

// The cheapest split: each of the two boxes costs its area times the number of spheres in it.
inline BinSplit cheapest_split(const Bins& all, const BinGrid& grid) {
    BinSplit best;
    Real best_cost = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        if (along(grid.bins_per_length, axis) == 0) continue;
        const auto& along_axis = all[static_cast<std::size_t>(axis)];
        std::array<Real, bins> right_cost{};
        Bin right, left;
        for (std::size_t b = bins; b-- > 1;) {
            right.add(along_axis[b]);
            right_cost[b] = right.cost();
        }
        for (std::size_t b = 1; b < bins; ++b) {
            left.add(along_axis[b - 1]);
            const Real cost = left.cost() + right_cost[b];
            if (cost < best_cost) {
                best_cost = cost;
                best = {axis, b};
            }
        }
    }
    return best;
}

// A split for build_node, like split_by_area. Moves the IDs so that the best split between two
// bins separates the first k of them from the rest. Returns k, or 0 if no such split has spheres on
// both sides.
inline int binned_split(std::span<int> order, std::span<const Box> boxes) {
    const BinGrid grid{order, boxes};
    const BinSplit best = cheapest_split(fill_bins(order, boxes, grid), grid);
    if (best.bin == 0) return 0;
    const auto cut = std::partition(order.begin(), order.end(), [&](int number) {
        return grid.bin_of(boxes[static_cast<std::size_t>(number)], best.axis) < best.bin;
    });
    const auto left = static_cast<int>(cut - order.begin());
    return left < static_cast<int>(order.size()) ? left : 0;
}

}  // namespace rt
