#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <rt/binary_tree.hpp>
#include <rt/box.hpp>
#include <utility>

namespace rt {

// A node of a tree of boxes (given). An inner node has two children; a leaf has none, and holds the
// shapes at the indices first, first + 1, ... of the tree's order.
struct TreeNode {
    Box box;  // around everything below
    std::unique_ptr<TreeNode> left, right;
    int first = 0, count = 0;

    bool is_leaf() const { return !left; }

    // The tree below is destroyed node by node, by take_apart of exercise 00.4. When take_apart
    // destroys a node, the node no longer has children, so its destructor returns at once.
    ~TreeNode() {
        if (is_leaf()) return;
        take_apart(std::move(left));
        take_apart(std::move(right));
    }
};

// Below this level, nodes are split in half, whatever they hold. The tree of a million shapes then
// has at most 64 + 20 levels, and no recursion over it can overflow the stack.
inline constexpr int most_levels = 64;

// The largest number of shapes in a leaf when nodes are split in half.
inline constexpr int leaf_size = 4;

// How many times `things` must be halved, rounding up, until `few` or fewer are left.
constexpr std::size_t halvings(std::int64_t things, std::int64_t few) {
    std::size_t count = 0;
    for (; things > few; things -= things / 2) ++count;
    return count;
}

}  // namespace rt
