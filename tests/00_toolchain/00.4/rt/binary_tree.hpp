#pragma once
#include <concepts>
#include <memory>

#include "../../watched.hpp"

namespace answer {

using checkpoint::WatchedNode;

std::unique_ptr<WatchedNode> make_tree(int first, int last);
int count_nodes(const WatchedNode* root);
int depth_of(const WatchedNode* root);
void take_apart(std::unique_ptr<WatchedNode> root);

// The learner's are templates, called as rt::make_tree<WatchedNode>(first, last).
template <std::same_as<WatchedNode> Node>
std::unique_ptr<Node> make_tree(int first, int last) {
    return make_tree(first, last);
}
template <std::same_as<WatchedNode> Node>
int count_nodes(const Node* root) {
    return answer::count_nodes(root);
}
template <std::same_as<WatchedNode> Node>
int depth_of(const Node* root) {
    return answer::depth_of(root);
}

}  // namespace answer

namespace rt {

using answer::count_nodes;
using answer::depth_of;
using answer::make_tree;
using answer::take_apart;

}  // namespace rt
