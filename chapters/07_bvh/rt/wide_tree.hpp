#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <rt/any_hit.hpp>
#include <rt/find_nearest.hpp>
#include <rt/tree.hpp>
#include <rt/wide_search.hpp>
#include <vector>

namespace rt {

// A world of shapes in a tree with eight children per node and up to eight shapes per leaf (given).
// It finds the same hits as a list, bit for bit, in scenes with coordinates and radii of 1e-15 to
// 1e15 in size. The boxes' coordinates are of type Number: float is enough for boxes, even if Real
// is double. make_wide_tree in wide_builder.hpp makes such a tree.
template <class Shape, class Number = float>
struct WideTreeOf {
    using BoxNumber = Number;
    using Leaf = WideLeaf<Shape>;
    using ReadyRay = typename Leaf::ReadyRay;
    std::vector<WideNode<Number>> nodes;  // the first is the root; empty without shapes
    std::vector<WideLeaf<Shape>> leaves;
    std::vector<std::uint32_t> places;  // of each shape: lanes * its leaf + its place there

    decltype(auto) shape(std::int32_t number) const {
        const std::uint32_t place = places[static_cast<std::size_t>(number)];
        return leaves[place / lanes].shape(place % lanes);
    }

    // The most nodes on the way down to a leaf: each of them replaces at least one split of the
    // binary tree.
    static constexpr std::size_t most_nodes =
        most_levels + halvings(std::numeric_limits<std::int32_t>::max(), leaf_size);

    using Search = WideSearch<WideTreeOf>;

    Search search(const Ray& ray, Interval within) const {
        Search search{*this, ReadyRay{ray}, wide_ray<Number>(ray), within, -1};
        if (!nodes.empty()) find_nearest(WideChild::node(0), search);
        return search;
    }

    // The same for a ray that is ready for boxes. The search may begin at any node or leaf, and a
    // hit on shape `number` at within.max may already be known.
    RT_INLINED Search search(const Ray& ray, const WideRay<Number>& wide, Interval within,
                             WideChild child, std::int32_t number) const {
        Search search{*this, ReadyRay{ray}, wide, within, number};
        find_nearest(child, search);
        return search;
    }

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        return hit_of(search(ray, within));
    }

    // True if anything is hit within the interval, whatever it is: the search ends at the first hit
    // that it finds. If the ray meets shape `number` at within.max, only other shapes count, and
    // only if they come before that shape according to the rules of hit().
    template <class AnyRay>
    bool occluded(const AnyRay& any_ray, Interval within, std::int32_t number = -1) const {
        const Ray& ray = any_ray;  // no copy if any_ray is a plain Ray
        AnyHit<Search> search{{*this, ReadyRay{ray}, wide_ray<Number>(ray), within, number}};
        if (!nodes.empty()) find_nearest(WideChild::node(0), search);
        return search.found();
    }
};

using WideTree = WideTreeOf<SceneSphere>;

}  // namespace rt
