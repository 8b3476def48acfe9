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
    using Items = std::span<BuildItem>;

    WideBuilder(WideTreeOf<Number>& tree, std::span<const SceneSphere> spheres)
        : tree_{tree}, spheres_{spheres} {
        std::vector<BuildItem> items;
        items.reserve(spheres.size());
        for (const SceneSphere& sphere : spheres)
            items.push_back({wide_bounds_of(sphere.shape), static_cast<int>(items.size())});
        tree.leaves.reserve(items.size() / 5);
        tree.nodes.reserve(items.size() / 25 + 1);
        if (!items.empty()) add_node(items, 0);
        tree.leaves.shrink_to_fit();
        tree.nodes.shrink_to_fit();
    }

  private:
    // The sphere's box, grown so that it contains the sphere also after its own rounding to Number
    // and that of the slabs, which are computed in Number.
    static Box wide_bounds_of(const Sphere& sphere) {
        const Box box = bounds_of(sphere);
        if (wide_margin<Number> <= hit_margin) return box;  // it is grown by hit_margin already
        const Real grow =
            wide_margin<Number> * std::max(max_component(box.low), max_component(box.high));
        const Vec3 margin{grow, grow, grow};
        return {box.low - margin, box.high + margin};
    }

    static Box box_of(Items items) {
        Box box;
        for (const BuildItem& item : items) box = join(box, item.box);
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
            Box box;
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
                    (!largest || half_area(parts[i].box) > half_area(largest->box)))
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
            const Box box = i < count ? parts[i].box : Box{};
            for (int axis = 0; axis < 3; ++axis) {
                const auto k = static_cast<std::size_t>(axis);
                node.planes[0][k][i] = static_cast<Number>(along(box.low, axis));
                node.planes[1][k][i] = static_cast<Number>(along(box.high, axis));
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
