#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <rt/dot.hpp>
#include <rt/lamp_tree.hpp>
#include <rt/pick.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 14.5. The lamp that a random number chooses for the light at the point `from`, 0 <=
// number < 1, with its probability and the rest of the number: as `pick` does. Without the star, it
// is the pick from tree.shares, wherever `from` is.
// Star: a walk down the tree. The root has the part [0, 1) of all numbers. At each node, its part
// is divided among the left child, which comes first, and the right one, in proportion to their
// importance: power / distance^2, where the distance is that from `from` to the center of the
// child's box, but at least an eighth of the diagonal of the node's box. Where both distances are
// 0, the powers count alone. All ends of parts are multiples of epsilon / 2, and each lamp has at
// least one such step: the probability is exactly that of the choice, up to 10 steps off the
// formula. If the tree has no nodes, the probability is 0.
// Source: Conty Estevez and Kulla, "Importance sampling of many lights with adaptive tree
// splitting", HPG 2018.
inline Pick choose_lamp(const LampTree& tree, Vec3 from, Real number) {
    return rt::todo("14.5", tree, from, number);
}

// The probability with which choose_lamp takes this lamp for the light at the point `from`. Without
// the star, it is that of the lamp in tree.shares.
// Star: by the same walk, toward the lamp's place; 0 for a lamp that is not in the tree.
inline Real lamp_probability(const LampTree& tree, Vec3 from, std::size_t lamp) {
    return rt::todo("14.5", tree, from, lamp);
}

}  // namespace rt
