#include <answer.hpp>
#include <rt/build.hpp>

#include "types.hpp"

namespace answer EXPORTED {

int split_in_half(std::span<int> order, std::span<const rt::Box> boxes) {
    return rt::split_in_half(order, boxes);
}

std::unique_ptr<rt::TreeNode> build_in_half(std::span<int> order, int first,
                                            std::span<const rt::Box> boxes) {
    return rt::build_node(order, first, boxes, rt::split_in_half);
}

std::unique_ptr<rt::TreeNode> build_node(std::span<int> order, int first,
                                         std::span<const rt::Box> boxes, const Split& split) {
    return rt::build_node(order, first, boxes, split);
}

std::unique_ptr<rt::TreeNode> build_node(std::span<int> order, int first,
                                         std::span<const rt::Box> boxes, const Split& split,
                                         int level) {
    return rt::build_node(order, first, boxes, split, level);
}

}  // namespace EXPORTED
