#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <rt/compiler.hpp>
#include <rt/nearest_first.hpp>
#include <rt/wide_leaf.hpp>
#include <rt/wide_node.hpp>

namespace rt {

// A child whose box a ray meets, and where the ray enters the box.
template <class Number>
struct MetWideChild {
    Number entry;
    WideChild place;
    WideChild node() const { return place; }
};

// One ray on its way through a WideTreeOf, and the nearest hit so far (given). It has the functions
// of SearchOf, so that find_nearest (07.4) searches this tree, too; a WideChild is a node of it.
template <class Tree>
struct WideSearch {
    using Number = typename Tree::BoxNumber;
    using Leaf = typename Tree::Leaf;
    using Child = MetWideChild<Number>;

    const Tree& tree;
    typename Tree::Leaf::ReadyRay ray;
    WideRay<Number> wide;
    Interval within;    // its upper end moves down to the nearest hit
    int nearest;        // the number of the shape that was hit there
    int box_tests = 0;  // eight tests at once count as one
    int shape_tests = 0;

    RT_INLINED NearestFirst<Child, lanes> children_of(WideChild child) {
        ++box_tests;
        const WideNode<Number>& node = tree.nodes[static_cast<std::size_t>(child.number())];
        const Interval in = with_origin(within);
        const BoxesHit<Number> hit = hit_boxes(node, wide, scaled(in.min), scaled(in.max));
        NearestFirst<Child, lanes> met;
        for (unsigned bits = hit.met; bits; bits &= bits - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(bits));
            if constexpr (Leaf::read_ahead > 0) fetch(node.child[i]);
            met.add({hit.entry[i], node.child[i]});
        }
        return met;
    }
    RT_INLINED bool reaches(const Child& child) const {
        return child.entry <= scaled(with_origin(within).max);
    }
    RT_INLINED SomeOfLeaf shapes_in(WideChild child) {
        ++shape_tests;
        const Leaf& leaf = tree.leaves[static_cast<std::size_t>(child.number())];
        if constexpr (Leaf::read_ahead > 0) last_leaf = &leaf;
        return {leaf.number, may_meet(leaf, ray, within)};
    }
    decltype(auto) shape(int number) const { return tree.shape(number); }
    RT_INLINED std::optional<Real> meets_shape(int number) const {
        if constexpr (Leaf::read_ahead > 0)
            return hit_shape(last_leaf->shape(last_leaf->place_of(number)), ray, within);
        else
            return hit_shape(shape(number), ray, within);
    }

    const Leaf* last_leaf = nullptr;  // the one that was met last, if leaves are read ahead

  private:
    // Asks for a node or a leaf before it is needed: in a large tree it comes from far away. Either
    // is asked for in the same way, without a branch, which the processor would often guess wrong.
    void fetch(WideChild child) const {
        const auto number = static_cast<std::size_t>(child.number());
        const auto address = [&](const auto& parts) {
            return reinterpret_cast<const char*>(parts.data() + number);
        };
        const char* const part = child.is_leaf() ? address(tree.leaves) : address(tree.nodes);
        for (std::size_t at = 0; at < Leaf::read_ahead; at += 64) RT_PREFETCH(part + at);
    }
    Number scaled(Real t) const { return static_cast<Number>(t * wide.scale); }
};

}  // namespace rt
