#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace rt {

// The surface area heuristic without sorting (given): the spheres' middles fall into a few bins
// along each axis, and only splits between bins are tried. Linear time.
// Source: Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007.

// A box in numbers of the type of the tree, and whose it is. Middles are doubled: low + high.
template <class Number>
struct BuildItem {
    std::array<Number, 3> low, high;
    std::int32_t number = 0;

    Number middle(std::size_t axis) const { return low[axis] + high[axis]; }
};

template <class Number>
struct BuildBox {
    static constexpr Number far = std::numeric_limits<Number>::infinity();
    std::array<Number, 3> low{far, far, far}, high{-far, -far, -far};

    void add(const std::array<Number, 3>& other_low, const std::array<Number, 3>& other_high) {
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], other_low[k]);
        for (std::size_t k = 0; k < 3; ++k) high[k] = std::max(high[k], other_high[k]);
    }
    Number half_area() const {
        const Number x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
};

inline constexpr std::size_t bins = 16;

// Bins of equal width along each axis, from the first middle to the last one.
template <class Number>
struct BinGrid {
    std::array<Number, 3> first;
    std::array<Number, 3> bins_per_length;  // 0 where all middles are at one place
    std::size_t longest = 0;                // the axis along which the middles are spread most

    explicit BinGrid(std::span<const BuildItem<Number>> items) {
        BuildBox<Number> middles;
        for (const auto& item : items) {
            const std::array<Number, 3> middle{item.middle(0), item.middle(1), item.middle(2)};
            middles.add(middle, middle);
        }
        first = middles.low;
        for (std::size_t k = 0; k < 3; ++k) {
            const Number length = middles.high[k] - middles.low[k];
            const Number scale = static_cast<Number>(bins) / length;
            bins_per_length[k] = scale < BuildBox<Number>::far ? scale : 0;
            if (length > middles.high[longest] - middles.low[longest]) longest = k;
        }
    }
    std::size_t bin_of(const BuildItem<Number>& item, std::size_t axis) const {
        const Number place = (item.middle(axis) - first[axis]) * bins_per_length[axis];
        return std::min(static_cast<std::size_t>(place), bins - 1);
    }
};

template <class Number>
struct Bin {
    BuildBox<Number> box;
    std::int32_t count = 0;

    void add(const Bin& other) {
        box.add(other.box.low, other.box.high);
        count += other.count;
    }
    Number cost() const { return box.half_area() * static_cast<Number>(count); }
};

// What lies in the bins along each axis.
template <class Number>
using Bins = std::array<std::array<Bin<Number>, bins>, 3>;

template <class Number>
Bins<Number> fill_bins(std::span<const BuildItem<Number>> items, const BinGrid<Number>& grid) {
    Bins<Number> all{};
    for (const auto& item : items)
        for (std::size_t k = 0; k < 3; ++k) {
            Bin<Number>& bin = all[k][grid.bin_of(item, k)];
            bin.box.add(item.low, item.high);
            ++bin.count;
        }
    return all;
}

// A split before a bin; before the first one there is none.
struct BinSplit {
    std::size_t axis = 0, bin = 0;
};

// The cheapest one, by the areas of the two boxes times what is in them.
template <class Number>
BinSplit cheapest_split(const Bins<Number>& all, const BinGrid<Number>& grid) {
    BinSplit best;
    Number best_cost = BuildBox<Number>::far;
    for (std::size_t k = 0; k < 3; ++k) {
        if (grid.bins_per_length[k] == 0) continue;
        std::array<Number, bins> right_cost{};
        Bin<Number> right, left;
        for (std::size_t b = bins; b-- > 1;) {
            right.add(all[k][b]);
            right_cost[b] = right.cost();
        }
        for (std::size_t b = 1; b < bins; ++b) {
            left.add(all[k][b - 1]);
            const Number cost = left.cost() + right_cost[b];
            if (cost < best_cost) {
                best_cost = cost;
                best = {k, b};
            }
        }
    }
    return best;
}

// Moves the items so that the best split is between the first k and the rest; returns k, at least 1
// and less than all. There must be two items or more. Where no split is better than another, or
// `in_half` asks for it, k is half.
template <class Number>
std::size_t binned_split(std::span<BuildItem<Number>> items, bool in_half) {
    const BinGrid<Number> grid{items};
    const BinSplit best =
        in_half ? BinSplit{} : cheapest_split(fill_bins<Number>(items, grid), grid);
    if (best.bin > 0) {
        const auto cut = std::partition(items.begin(), items.end(), [&](const auto& item) {
            return grid.bin_of(item, best.axis) < best.bin;
        });
        const auto left = static_cast<std::size_t>(cut - items.begin());
        if (left > 0 && left < items.size()) return left;
    }
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [&](const auto& a, const auto& b) {
                         return a.middle(grid.longest) < b.middle(grid.longest);
                     });
    return half;
}

}  // namespace rt
