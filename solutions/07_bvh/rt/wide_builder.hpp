#pragma once
#include <rt/binned_split.hpp>
#include <rt/bounds.hpp>
#include <rt/tree.hpp>
#include <rt/wide_tree.hpp>
#include <span>

namespace rt {

// Builds a WideTreeOf<Number>, top down.
template <class Number>
class WideBuilder {
  public:
    using Items = std::span<BuildItem<Number>>;

    WideBuilder(WideTreeOf<Number>& tree, std::span<const SceneSphere> spheres)
        : tree_{tree}, spheres_{spheres} {
        std::vector<BuildItem<Number>> items;
        items.reserve(spheres.size());
        for (const SceneSphere& sphere : spheres) items.push_back(item_of(sphere.shape));
        for (std::size_t i = 0; i < items.size(); ++i) items[i].number = static_cast<int>(i);
        tree.leaves.reserve(items.size() / 5);
        tree.nodes.reserve(items.size() / 25 + 1);
        if (!items.empty()) add_node(items, 0);
        tree.leaves.shrink_to_fit();
        tree.nodes.shrink_to_fit();
    }

  private:
    // A box in Number that contains the box of Real also after its own rounding and that of the
    // slabs, which are computed in Number.
    static BuildItem<Number> item_of(const Sphere& sphere) {
        const Box box = bounds_of(sphere);
        const Real largest = std::max(max_component(box.low), max_component(box.high));
        constexpr Real slab = 8 * static_cast<Real>(std::numeric_limits<Number>::epsilon());
        const Real grow = slab > hit_margin ? slab * largest : 0;
        BuildItem<Number> item;
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            item.low[k] = static_cast<Number>(along(box.low, axis) - grow);
            item.high[k] = static_cast<Number>(along(box.high, axis) + grow);
        }
        return item;
    }

    static BuildBox<Number> box_of(Items items) {
        BuildBox<Number> box;
        for (const auto& item : items) box.add(item.low, item.high);
        return box;
    }

    std::int32_t add_leaf(Items items) {
        WideLeaf leaf;
        for (std::size_t i = 0; i < items.size(); ++i)
            leaf.set(i, spheres_[static_cast<std::size_t>(items[i].number)], items[i].number);
        tree_.leaves.push_back(leaf);
        return ~static_cast<std::int32_t>(tree_.leaves.size() - 1);
    }

    std::int32_t add_node(Items items, int level) {
        struct Part {
            Items items;
            BuildBox<Number> box;
            int level;
        };
        std::array<Part, lanes> parts;
        std::size_t count = 1;
        parts[0] = {items, box_of(items), level};
        while (count < lanes) {
            // The part with the largest box is met most often: it is split next.
            Part* largest = nullptr;
            for (std::size_t i = 0; i < count; ++i)
                if (parts[i].items.size() > lanes &&
                    (!largest || parts[i].box.half_area() > largest->box.half_area()))
                    largest = &parts[i];
            if (!largest) break;
            const int below = largest->level + 1;
            const Items all = largest->items;
            const std::size_t left = binned_split(all, largest->level >= most_levels);
            *largest = {all.first(left), box_of(all.first(left)), below};
            parts[count++] = {all.subspan(left), box_of(all.subspan(left)), below};
        }

        const std::size_t place = tree_.nodes.size();
        tree_.nodes.emplace_back();
        WideNode<Number> node;
        for (std::size_t i = 0; i < lanes; ++i) {
            const BuildBox<Number> box = i < count ? parts[i].box : BuildBox<Number>{};
            for (std::size_t k = 0; k < 3; ++k) {
                node.planes[0][k][i] = box.low[k];
                node.planes[1][k][i] = box.high[k];
            }
            // Only a ray that is not finite meets the empty box of an unused lane: it comes to the
            // first leaf, of which there is always one, and to an end.
            node.child[i] = ~0;
            if (i < count)
                node.child[i] = parts[i].items.size() <= lanes
                                    ? add_leaf(parts[i].items)
                                    : add_node(parts[i].items, parts[i].level);
        }
        tree_.nodes[place] = node;
        return static_cast<std::int32_t>(place);
    }

    WideTreeOf<Number>& tree_;
    std::span<const SceneSphere> spheres_;
};

template <class Number = float>
WideTreeOf<Number> make_wide_tree(const std::vector<SceneSphere>& spheres) {
    WideTreeOf<Number> tree;
    WideBuilder<Number>{tree, spheres};
    return tree;
}

}  // namespace rt
