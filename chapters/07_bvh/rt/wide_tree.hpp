#pragma once
#include <array>
#include <bit>
#include <optional>
#include <rt/tree.hpp>
#include <rt/wide_leaf.hpp>
#include <rt/wide_node.hpp>
#include <utility>
#include <vector>

namespace rt {

// A world of shapes in a tree with eight children per node and up to eight shapes per leaf (given).
// It finds the same hits as a list, bit for bit, in scenes with coordinates and radii of 1e-15 to
// 1e15 in size. The boxes' coordinates are of type Number: float is enough for boxes, even if Real
// is double. make_wide_tree in wide_builder.hpp makes such a tree.
template <class Shape, class Number = float>
struct WideTreeOf {
    std::vector<WideNode<Number>> nodes;  // the first is the root; empty without shapes
    std::vector<WideLeaf<Shape>> leaves;

    // The most nodes on the way down to a leaf: each of them replaces at least one split of the
    // binary tree.
    static constexpr std::size_t most_nodes =
        most_levels + halvings(std::numeric_limits<std::int32_t>::max(), leaf_size);

    struct Found {
        WideHit best;
        const WideLeaf<Shape>* leaf = nullptr;  // the leaf of the shape that was hit, if any
        int box_tests = 0, shape_tests = 0;     // eight tests at once count as one
    };

    Found search(const Ray& ray, Interval within) const {
        if (nodes.empty()) return {{within.max}};
        return search(ray, wide_ray<Number>(ray), within, WideChild::node(0), -1);
    }

    // The same for a ray that is ready for boxes. The search may begin at any node or leaf, and a
    // hit on shape `number` at within.max may already be known.
    RT_INLINED Found search(const Ray& ray, const WideRay<Number>& wide, Interval within,
                            WideChild child, std::int32_t number) const {
        Found found{{within.max, number}};
        const auto scaled = [&](Real t) { return static_cast<Number>(t * wide.scale); };
        const Number min = scaled(with_origin(within).min);
        Number max = scaled(with_origin(within).max);
        // Waiting children, the nearest on top. Of each node on the way down, all children but
        // one may wait.
        struct Waiting {
            Number entry;
            WideChild child;
        };
        std::array<Waiting, (lanes - 1) * most_nodes> stack;
        std::size_t waiting = 0;
        for (;;) {
            if (!child.is_leaf()) {
                ++found.box_tests;
                const WideNode<Number>& node = nodes[static_cast<std::size_t>(child.number())];
                const BoxesHit<Number> hit = hit_boxes(node, wide, min, max);
                if (hit.met != 0) {
                    const auto waiting_at = [&](unsigned met) -> Waiting {
                        const auto i = static_cast<std::size_t>(std::countr_zero(met));
                        return {hit.entry[i], node.child[i]};
                    };
                    // The nearest child is visited next. The others are few, often none, and are
                    // inserted in order, one by one.
                    Waiting next = waiting_at(hit.met);
                    const std::size_t bottom = waiting;
                    for (unsigned met = hit.met & (hit.met - 1); met; met &= met - 1) {
                        Waiting other = waiting_at(met);
                        if (other.entry < next.entry) std::swap(next, other);
                        std::size_t place = waiting++;
                        for (; place > bottom && stack[place - 1].entry < other.entry; --place)
                            stack[place] = stack[place - 1];
                        stack[place] = other;
                    }
                    child = next.child;
                    continue;
                }
            } else {
                ++found.shape_tests;
                const WideLeaf<Shape>& leaf = leaves[static_cast<std::size_t>(child.number())];
                if (hit_leaf(leaf, ray, within.min, found.best)) {
                    found.leaf = &leaf;
                    max = scaled(with_origin({within.min, found.best.t}).max);
                }
            }
            // Meanwhile a hit may have been found in front of the waiting children.
            do
                if (waiting == 0) return found;
            while (stack[--waiting].entry > max);
            child = stack[waiting].child;
        }
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray& ray = any_ray;  // no copy if any_ray is a plain Ray
        const Found found = search(ray, within);
        if (!found.leaf) return {};
        return found.leaf->hit(found.best.place, ray, found.best.t);
    }

    // True if anything is hit within the interval, whatever it is: the search ends at the first hit
    // that it finds. If the ray meets shape `number` at within.max, only other shapes count, and
    // only if they come before that shape according to the rules of hit().
    template <class AnyRay>
    bool occluded(const AnyRay& any_ray, Interval within, std::int32_t number = -1) const {
        if (nodes.empty()) return false;
        const Ray& ray = any_ray;  // no copy if any_ray is a plain Ray
        const WideHit end{within.max, number};
        const auto wide = wide_ray<Number>(ray);
        const auto min = static_cast<Number>(with_origin(within).min * wide.scale);
        const auto max = static_cast<Number>(with_origin(within).max * wide.scale);
        std::array<WideChild, (lanes - 1) * most_nodes + 1> stack;
        stack[0] = WideChild::node(0);
        for (std::size_t waiting = 1; waiting > 0;) {
            const WideChild child = stack[--waiting];
            const auto index = static_cast<std::size_t>(child.number());
            if (child.is_leaf()) {
                if (any_in_leaf(leaves[index], ray, within.min, end)) return true;
                continue;
            }
            const WideNode<Number>& node = nodes[index];
            for (unsigned met = hit_boxes(node, wide, min, max).met; met; met &= met - 1)
                stack[waiting++] = node.child[static_cast<std::size_t>(std::countr_zero(met))];
        }
        return false;
    }
};

using WideTree = WideTreeOf<SceneSphere>;

}  // namespace rt
