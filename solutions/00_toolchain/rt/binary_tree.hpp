#pragma once
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace rt {

// Node is any type with two members std::unique_ptr<Node> left, right, such as rt::RangeNode. An
// empty tree is nullptr.

// A balanced tree over the numbers first, first + 1, ... last - 1. If last equals first, the tree
// is empty; last is never less than first, and last - first fits an int. The root is made from
// Node(first, last). If there is more than one number, the left child is the tree over the first
// half of them, and the right child the tree over the second half, which has one number more if the
// count is odd.
template <class Node>
std::unique_ptr<Node> make_tree(int first, int last) {
    if (first >= last) return nullptr;
    auto root = std::make_unique<Node>(first, last);
    if (last - first > 1) {
        // Not (first + last) / 2, because the sum may not fit an int.
        const int middle = first + (last - first) / 2;
        root->left = make_tree<Node>(first, middle);
        root->right = make_tree<Node>(middle, last);
    }
    return root;
}

// The number of nodes. If this function called itself, it would be two lines,
//   if (!root) return 0;
//   return 1 + count_nodes(root->left.get()) + count_nodes(root->right.get());
// but each call that waits for another takes room on the stack, and a tree may be a million nodes
// deep. So the list of nodes still to visit is on the heap.
template <class Node>
int count_nodes(const Node* root) {
    int count = 0;
    std::vector<const Node*> to_do{root};
    while (!to_do.empty()) {
        const Node* const node = to_do.back();
        to_do.pop_back();
        if (!node) continue;
        ++count;
        to_do.push_back(node->left.get());
        to_do.push_back(node->right.get());
    }
    return count;
}

// The number of nodes on the longest path from the root to a leaf: 0 for an empty tree, 1 for a
// root alone.
template <class Node>
int depth_of(const Node* root) {
    int deepest = 0;
    std::vector<std::pair<const Node*, int>> to_do{{root, 1}};
    while (!to_do.empty()) {
        const auto [node, depth] = to_do.back();
        to_do.pop_back();
        if (!node) continue;
        deepest = std::max(deepest, depth);
        to_do.emplace_back(node->left.get(), depth + 1);
        to_do.emplace_back(node->right.get(), depth + 1);
    }
    return deepest;
}

// Destroys a tree node by node, so that no destructor runs inside another. By default, a node's
// destructor destroys its children, their destructors destroy the grandchildren, and so on: the
// calls pile up on the stack.
template <class Node>
void take_apart(std::unique_ptr<Node> root) {
    std::vector<std::unique_ptr<Node>> to_do;
    to_do.push_back(std::move(root));
    while (!to_do.empty()) {
        const std::unique_ptr<Node> node = std::move(to_do.back());
        to_do.pop_back();
        if (!node) continue;
        to_do.push_back(std::move(node->left));
        to_do.push_back(std::move(node->right));
    }  // the node is destroyed here; it has no children any more
}

}  // namespace rt
