#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <rt/dot.hpp>
#include <rt/lamp_tree.hpp>
#include <rt/pick.hpp>

namespace rt {

// A part of [0, 1), from low up to high: that of a node of a tree of lamps, or of a lamp.
struct LampPart {
    Real low = 0, high = 1;
    int lamp = 0;
};

// Where a node's part is divided among its children: the left child's part ends there. Each child's
// share of it is in proportion to its importance, power / distance^2, as seen from `from`. The
// distance is that to the middle of the child's box, but at least an eighth of the diagonal of the
// node's own box: no nearness makes the other child too rare, which may be the only one that is not
// hidden.
//
// The place is a multiple of epsilon / 2, as random.uniform() is, and each lamp below keeps one
// such step at least. So each probability is exactly that with which the lamp is chosen.
inline Real end_of_left(const LampTree& tree, std::size_t index, Vec3 from, const LampPart& part) {
    const LampNode& node = tree.nodes[index];
    const LampNode& left = tree.nodes[index + 1];
    const LampNode& right = tree.nodes[static_cast<std::size_t>(node.right)];
    const Vec3 diagonal = node.box.size();
    const Real least = dot(diagonal, diagonal) / 64;
    const auto squared_distance = [&](const LampNode& child) {
        const Vec3 apart = child.box.center() - from;
        return std::max(dot(apart, apart), least);
    };
    const Real to_left = squared_distance(left), to_right = squared_distance(right);
    // Both may be 0, where all lamps are at the same point.
    const Real farther = to_left == to_right ? Real(1) : to_left / to_right;
    const Real share = left.power / (left.power + right.power * farther);

    constexpr Real step = epsilon / 2;
    const Real shared = part.high - part.low - step * static_cast<Real>(node.lamps());
    return part.low +
           step * (static_cast<Real>(left.lamps()) + std::floor(share * (shared / step)));
}

// Walks down from the root to a lamp. goes_left(left, middle) says which way to go: the left child,
// and where its part ends.
template <class GoesLeft>
LampPart walk_to_lamp(const LampTree& tree, Vec3 from, const GoesLeft& goes_left) {
    LampPart part;
    std::size_t index = 0;
    while (!tree.nodes[index].is_leaf()) {
        const Real middle = end_of_left(tree, index, from, part);
        if (goes_left(tree.nodes[index + 1], middle)) {
            part.high = middle;
            index += 1;
        } else {
            part.low = middle;
            index = static_cast<std::size_t>(tree.nodes[index].right);
        }
    }
    part.lamp = tree.order[static_cast<std::size_t>(tree.nodes[index].begin)];
    return part;
}

// The lamp that a random number chooses for the light at a point, 0 <= number < 1, its probability,
// and the rest of the number: as pick. If no lamp has any power, the probability is 0.
// Source: Conty Estevez and Kulla, "Importance sampling of many lights with adaptive tree
// splitting", HPG 2018.
inline Pick choose_lamp(const LampTree& tree, Vec3 from, Real number) {
    if (tree.nodes.empty()) return {};
    const LampPart part =
        walk_to_lamp(tree, from, [&](const LampNode&, Real middle) { return number < middle; });
    const Real probability = part.high - part.low;
    return {static_cast<std::size_t>(part.lamp), probability, (number - part.low) / probability};
}

// The probability with which choose_lamp takes this lamp for the light at a point.
inline Real lamp_probability(const LampTree& tree, Vec3 from, std::size_t lamp) {
    const int place = tree.places[lamp];
    if (place < 0) return 0;
    const LampPart part =
        walk_to_lamp(tree, from, [&](const LampNode& left, Real) { return place < left.end; });
    return part.high - part.low;
}

}  // namespace rt
