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
    int count = 0;
    std::vector<const Node*> to_do{root};
    for (const Node* const node : to_do) {
        if (!node) continue;
        ++count;
        to_do.push_back(node->left.get());
        to_do.push_back(node->right.get());
    }
    return count;
}

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
    }
}

}  // namespace rt
