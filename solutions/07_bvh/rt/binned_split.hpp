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

// Moves the items so that the best split is between the first k and the rest; returns k, at least 1
// and less than all. There must be two items or more. Where no split is better than another, or
// `in_half` asks for it, k is half.
template <class Number>
std::size_t binned_split(std::span<BuildItem<Number>> items, bool in_half) {
    BuildBox<Number> middles;
    for (const auto& item : items)
        for (std::size_t k = 0; k < 3; ++k) {
            middles.low[k] = std::min(middles.low[k], item.middle(k));
            middles.high[k] = std::max(middles.high[k], item.middle(k));
        }
    std::array<Number, 3> bins_per_length{};
    std::size_t longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Number length = middles.high[k] - middles.low[k];
        // Along an axis on which all are at one place there is nothing to split.
        const Number scale = static_cast<Number>(bins) / length;
        bins_per_length[k] = scale < BuildBox<Number>::far ? scale : 0;
        if (length > middles.high[longest] - middles.low[longest]) longest = k;
    }
    const auto bin_of = [&](const BuildItem<Number>& item, std::size_t k) {
        const auto bin =
            static_cast<std::size_t>((item.middle(k) - middles.low[k]) * bins_per_length[k]);
        return std::min(bin, bins - 1);
    };

    struct Bin {
        BuildBox<Number> box;
        std::int32_t count = 0;
    };
    std::array<std::array<Bin, bins>, 3> all{};
    if (!in_half)
        for (const auto& item : items)
            for (std::size_t k = 0; k < 3; ++k) {
                Bin& bin = all[k][bin_of(item, k)];
                bin.box.add(item.low, item.high);
                ++bin.count;
            }

    Number best_cost = BuildBox<Number>::far;
    std::size_t best_axis = 0, best_bin = 0;
    for (std::size_t k = 0; k < 3 && !in_half; ++k) {
        if (bins_per_length[k] == 0) continue;
        std::array<Number, bins> right_cost{};
        Bin right, left;
        for (std::size_t b = bins; b-- > 1;) {
            right.box.add(all[k][b].box.low, all[k][b].box.high);
            right.count += all[k][b].count;
            right_cost[b] = right.box.half_area() * static_cast<Number>(right.count);
        }
        for (std::size_t b = 1; b < bins; ++b) {
            left.box.add(all[k][b - 1].box.low, all[k][b - 1].box.high);
            left.count += all[k][b - 1].count;
            const Number cost =
                left.box.half_area() * static_cast<Number>(left.count) + right_cost[b];
            if (cost < best_cost) {
                best_cost = cost;
                best_axis = k;
                best_bin = b;
            }
        }
    }
    if (best_bin > 0) {
        const auto cut = std::partition(items.begin(), items.end(), [&](const auto& item) {
            return bin_of(item, best_axis) < best_bin;
        });
        const auto left = static_cast<std::size_t>(cut - items.begin());
        if (left > 0 && left < items.size()) return left;
    }
    const std::size_t half = items.size() / 2;
    std::nth_element(
        items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
        [&](const auto& a, const auto& b) { return a.middle(longest) < b.middle(longest); });
    return half;
}

}  // namespace rt
