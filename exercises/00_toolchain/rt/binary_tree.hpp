#pragma once
#include <algorithm>
#include <memory>
#include <rt/todo.hpp>
#include <utility>
#include <vector>

namespace rt {

// Node is any type that, like rt::RangeNode, has two members std::unique_ptr<Node> left, right. An
// empty tree is nullptr.

// Exercise 00.4. A balanced tree over the numbers first ... last - 1, which may be negative. If
// last equals first, the tree is empty; last is never less than first, and last - first fits an
// int. The root is std::make_unique<Node>(first, last). If there is more than one number, the left
// child is the tree over the first half of the numbers, and the right child the tree over the rest,
// which has one number more than the first half if the count is odd.
template <class Node>
std::unique_ptr<Node> make_tree(int first, int last) {
    return rt::todo("00.4", first, last);
}

// Exercise 00.4. The number of nodes.
// Star: a tree may be a million nodes deep.
template <class Node>
int count_nodes(const Node* root) {
    return rt::todo("00.4", root);
}

// Exercise 00.4. The number of nodes on the longest path from the root to a leaf: 0 for an empty
// tree, 1 for a root alone.
// Star: a tree may be a million nodes deep.
template <class Node>
int depth_of(const Node* root) {
    return rt::todo("00.4", root);
}

// Exercise 00.4. Destroys a tree.
// Star: node by node, so that no node's destructor runs inside another node's, however deep the
// tree is.
template <class Node>
void take_apart(std::unique_ptr<Node> root) {
    rt::todo("00.4", root);
}

}  // namespace rt
