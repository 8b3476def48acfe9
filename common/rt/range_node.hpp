#pragma once
#include <memory>

namespace rt {

// A node of a binary tree over numbered things: it stands for the things from number `first` up to,
// but not including, number `last`. It owns its two children; a leaf has none.
struct RangeNode {
    RangeNode(int first_thing, int end) : first{first_thing}, last{end} {}

    int first, last;
    std::unique_ptr<RangeNode> left, right;
};

}  // namespace rt
