#pragma once
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace rt {

template <class Node>
std::unique_ptr<Node> make_tree(int first, int last) {
    if (first >= last) return nullptr;
    auto root = std::make_unique<Node>(first, last);
    if (last - first > 1) {
        const int middle = first + (last - first) / 2;
        root->left = make_tree<Node>(first, middle);
        root->right = make_tree<Node>(middle, last);
    }
    return root;
}

template <class Node>
int count_nodes(const Node* root) {
    return root ? 1 + count_nodes(root->left.get()) + count_nodes(root->right.get()) : 0;
}

template <class Node>
int depth_of(const Node* root) {
    if (!root) return 0;
    return 1 + std::max(depth_of(root->left.get()), depth_of(root->right.get()));
}

template <class Node>
void take_apart(std::unique_ptr<Node> root) {
    root.reset();
}

}  // namespace rt
