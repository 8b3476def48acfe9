#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <rt/bounds.hpp>
#include <span>

namespace rt {

// The surface area heuristic without sorting (given): the spheres' middles fall into a few bins
// along each axis, and only splits between bins are tried. Linear time.
// Source: Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007.

// A box, and whose it is.
struct BuildItem {
    Box box;
    std::int32_t number = 0;

    // Twice the middle: halving it would change no split.
    Vec3 middle() const { return box.low + box.high; }
};

// Half of the area of a box's six faces; 0 for the empty box.
inline Real half_area(const Box& box) {
    const Vec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

inline constexpr std::size_t bins = 16;

// Bins of equal width along each axis, from the first middle to the last one.
struct BinGrid {
    Box middles;
    Vec3 bins_per_length;  // 0 where all middles are at one place

    explicit BinGrid(std::span<const BuildItem> items) {
        for (const BuildItem& item : items) {
            const Vec3 middle = item.middle();
            middles = join(middles, {middle, middle});
        }
        const auto per_length = [](Real length) {
            const Real scale = static_cast<Real>(bins) / length;
            return scale < infinity ? scale : 0;
        };
        const Vec3 size = middles.size();
        bins_per_length = {per_length(size.x), per_length(size.y), per_length(size.z)};
    }
    std::size_t bin_of(const BuildItem& item, int axis) const {
        const Real from_first = along(item.middle(), axis) - along(middles.low, axis);
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
    Real cost() const { return half_area(box) * static_cast<Real>(count); }
};

// What lies in the bins along each axis.
using Bins = std::array<std::array<Bin, bins>, 3>;

inline Bins fill_bins(std::span<const BuildItem> items, const BinGrid& grid) {
    Bins all{};
    for (const BuildItem& item : items)
        for (int axis = 0; axis < 3; ++axis)
            all[static_cast<std::size_t>(axis)][grid.bin_of(item, axis)].add({item.box, 1});
    return all;
}

// A split before a bin; before the first one there is none.
struct BinSplit {
    int axis = 0;
    std::size_t bin = 0;
};

// The cheapest one, by the areas of the two boxes times what is in them.
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

// Moves the items so that the best split is between the first k and the rest; returns k, at least 1
// and less than all. There must be two items or more. Where no split is better than another, or
// `in_half` asks for it, k is half.
inline std::size_t binned_split(std::span<BuildItem> items, bool in_half) {
    const BinGrid grid{items};
    const BinSplit best = in_half ? BinSplit{} : cheapest_split(fill_bins(items, grid), grid);
    if (best.bin > 0) {
        const auto cut = std::partition(items.begin(), items.end(), [&](const BuildItem& item) {
            return grid.bin_of(item, best.axis) < best.bin;
        });
        const auto left = static_cast<std::size_t>(cut - items.begin());
        if (left > 0 && left < items.size()) return left;
    }
    const std::size_t half = items.size() / 2;
    const int axis = longest_axis(grid.middles);
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [&](const BuildItem& a, const BuildItem& b) {
                         return along(a.middle(), axis) < along(b.middle(), axis);
                     });
    return half;
}

}  // namespace rt
