#pragma once
#include "../types.hpp"

namespace answer {

void descend(Tree& tree, std::int32_t node, rt::PathList list, rt::Scratch scratch);

// A tree of any type.
template <class AnyTree>
struct TreeOf : Tree {
    explicit TreeOf(AnyTree& used) : tree{used} {}
    unsigned test(std::int32_t node, rt::PathList list, std::uint8_t* masks) override {
        return tree.test(node, list, masks);
    }
    const std::array<std::uint8_t, 8>& order(std::int32_t node) const override {
        return tree.order(node);
    }
    rt::WideChild child(std::int32_t node, unsigned place) const override {
        return tree.child(node, place);
    }
    void leaf(std::int32_t number, rt::PathList list) override { tree.leaf(number, list); }

    AnyTree& tree;
};

}  // namespace answer

namespace rt {

template <class Tree>
void descend(Tree& tree, std::int32_t node, PathList list, Scratch scratch) {
    answer::TreeOf<Tree> any{tree};
    answer::descend(any, node, list, scratch);
}

}  // namespace rt
