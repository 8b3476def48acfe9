#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <rt/tree.hpp>
#include <rt/wide.hpp>
#include <utility>
#include <vector>

namespace rt {

// Which nodes of a binary tree become the children of the wide nodes (given). A ray meets a box
// about as often as its surface is large, and each wide node that it meets costs it one test of
// eight boxes. So the best wide tree is the one whose nodes have the smallest area in all.
// Source: Ylitalo, Karras and Laine, "Efficient incoherent ray traversal on GPUs through compressed
// wide BVHs", HPG 2017.
class WideCut {
  public:
    // A node, and its number in the order in which each node comes before what is below it, and the
    // left child before the right one.
    struct Numbered {
        const TreeNode* node;
        std::size_t number;
    };

    // The tree has this many leaves.
    WideCut(const TreeNode& root, std::size_t leaves) {
        areas_.reserve(2 * leaves - 1);
        measure(root);
    }

    // The nodes that become the children of the wide node that replaces `top`: up to eight, from
    // the left to the right. If `top` is a leaf, it is the only one.
    std::vector<Numbered> children(Numbered top) const {
        std::vector<Numbered> all;
        if (top.node->is_leaf())
            all.push_back(top);
        else
            open(top, lanes, all);
        return all;
    }

  private:
    // What it takes to replace a node and all nodes below it.
    struct Areas {
        // The smallest area of wide nodes in all, if at most i + 1 nodes remain at the top, wide
        // nodes or leaves. More need not be known: each child of a wide node has a sibling.
        std::array<float, lanes - 1> with{};
        std::int32_t end = 0;  // the number of the first node that is no longer below this one
    };
    // How many of the nodes at the top come from the left child, and the smallest area for that.
    struct Share {
        std::size_t left = 1;
        float area = std::numeric_limits<float>::infinity();
    };

    Share best_share(const Areas& left, const Areas& right, std::size_t nodes) const {
        Share best;
        for (std::size_t k = 1; k < nodes; ++k)
            if (const float area = left.with[k - 1] + right.with[nodes - k - 1]; area < best.area)
                best = {k, area};
        return best;
    }
    std::pair<Numbered, Numbered> children_of(Numbered parent) const {
        const std::size_t left = parent.number + 1;
        return {{parent.node->left.get(), left},
                {parent.node->right.get(), static_cast<std::size_t>(areas_[left].end)}};
    }

    void measure(const TreeNode& node) {
        const std::size_t number = areas_.size();
        areas_.emplace_back();
        Areas areas;
        if (!node.is_leaf()) {
            measure(*node.left);
            const std::size_t right_number = areas_.size();
            measure(*node.right);
            const Areas &left = areas_[number + 1], &right = areas_[right_number];
            areas.with[0] =
                static_cast<float>(surface_area(node.box)) + best_share(left, right, lanes).area;
            for (std::size_t nodes = 2; nodes < lanes; ++nodes)
                areas.with[nodes - 1] =
                    std::min(areas.with[nodes - 2], best_share(left, right, nodes).area);
        }
        areas.end = static_cast<std::int32_t>(areas_.size());
        areas_[number] = areas;
    }

    // Adds the nodes that remain if at most so many replace the two children of `parent`.
    void open(Numbered parent, std::size_t nodes, std::vector<Numbered>& all) const {
        const auto [left, right] = children_of(parent);
        const std::size_t on_left =
            best_share(areas_[left.number], areas_[right.number], nodes).left;
        add(left, on_left, all);
        add(right, nodes - on_left, all);
    }
    void add(Numbered top, std::size_t nodes, std::vector<Numbered>& all) const {
        const auto& with = areas_[top.number].with;
        while (nodes > 1 && with[nodes - 2] <= with[nodes - 1]) --nodes;
        if (nodes == 1 || top.node->is_leaf())
            all.push_back(top);
        else
            open(top, nodes, all);
    }

    std::vector<Areas> areas_;  // by the nodes' numbers
};

}  // namespace rt
