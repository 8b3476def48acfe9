#pragma once
#include <bit>
#include <limits>
#include <optional>
#include <rt/binned_split.hpp>
#include <rt/bounds.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/sphere_list.hpp>
#include <rt/tree.hpp>
#include <rt/wide_node.hpp>
#include <vector>

namespace rt {

// A world of spheres in a tree with eight children a node and up to eight spheres a leaf (given).
// It gives the hits of SphereList, bit for bit. The boxes' coordinates are of type Number: float
// is enough for boxes, also where Real is double.
template <class Number>
struct WideTreeOf {
    std::vector<WideNode<Number>> nodes;  // the first is the root; none without spheres
    std::vector<WideLeaf> leaves;

    struct Found {
        int nearest = -1;  // the number of the sphere
        Real t = 0;
        const WideLeaf* leaf = nullptr;  // where it is, and its place there
        std::size_t place = 0;
        int box_tests = 0, sphere_tests = 0;  // eight at once count as one
    };

    Found search(const Ray& ray, Interval within) const {
        Found found;
        if (nodes.empty()) return found;
        // What waits, the nearest on top: a child, and where the ray enters its box. A split in two
        // leaves one child waiting, one in eight seven at most, on each level.
        std::array<std::int32_t, 8 * (most_levels + 32)> waiting_child;
        std::array<Number, 8 * (most_levels + 32)> waiting_enters;
        const WideRay<Number> wide{ray};
        const auto scaled = [&](Real t) { return static_cast<Number>(t * wide.scale); };
        const Number min = scaled(with_origin(within).min);
        Number max = scaled(with_origin(within).max);
        waiting_child[0] = 0;
        waiting_enters[0] = min;
        std::size_t waiting = 1;
        while (waiting > 0) {
            --waiting;
            if (waiting_enters[waiting] > max) continue;  // meanwhile a hit was found before it
            const std::int32_t child = waiting_child[waiting];
            if (child >= 0) {
                ++found.box_tests;
                const WideNode<Number>& node = nodes[static_cast<std::size_t>(child)];
                Lanes<Number> enters;
                // There are few: they are put into their order one by one.
                const std::size_t bottom = waiting;
                for (unsigned met = hit_boxes(node, wide, min, max, enters); met; met &= met - 1) {
                    const auto i = static_cast<std::size_t>(std::countr_zero(met));
                    const Number at = enters[i];
                    std::size_t place = waiting++;
                    for (; place > bottom && waiting_enters[place - 1] < at; --place) {
                        waiting_enters[place] = waiting_enters[place - 1];
                        waiting_child[place] = waiting_child[place - 1];
                    }
                    waiting_enters[place] = at;
                    waiting_child[place] = node.child[i];
                }
                continue;
            }
            ++found.sphere_tests;
            const WideLeaf& leaf = leaves[static_cast<std::size_t>(~child)];
            for (unsigned met = may_hit(leaf, ray); met; met &= met - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(met));
                const auto t = hit_sphere(leaf.sphere(i), ray, within);
                if (!t) continue;
                if (found.nearest >= 0 && *t == found.t && leaf.number[i] < found.nearest) continue;
                found.nearest = leaf.number[i];
                found.leaf = &leaf;
                found.place = i;
                found.t = within.max = *t;
                max = scaled(with_origin(within).max);
            }
        }
        return found;
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray ray{any_ray.origin, any_ray.direction};
        const Found found = search(ray, within);
        if (found.nearest < 0) return {};
        Hit hit = surface_hit(found.leaf->sphere(found.place), ray, found.t);
        hit.material = found.leaf->material[found.place];
        return hit;
    }
};

using WideTree = WideTreeOf<float>;

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
                node.low[k][i] = box.low[k];
                node.high[k][i] = box.high[k];
            }
            node.child[i] = 0;
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
