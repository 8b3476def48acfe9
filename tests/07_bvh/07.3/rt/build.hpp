#pragma once
#include <memory>
#include <rt/bounds.hpp>
#include <rt/tree.hpp>
#include <type_traits>

#include "../types.hpp"

namespace answer {

int split_in_half(std::span<int> order, std::span<const rt::Box> boxes);
// With split_in_half itself.
std::unique_ptr<rt::TreeNode> build_in_half(std::span<int> order, int first,
                                            std::span<const rt::Box> boxes);
std::unique_ptr<rt::TreeNode> build_node(std::span<int> order, int first,
                                         std::span<const rt::Box> boxes, const Split& split);
std::unique_ptr<rt::TreeNode> build_node(std::span<int> order, int first,
                                         std::span<const rt::Box> boxes, const Split& split,
                                         int level);

}  // namespace answer

namespace rt {

using answer::split_in_half;

template <class Split, class... Level>
std::unique_ptr<TreeNode> build_node(std::span<int> order, int first, std::span<const Box> boxes,
                                     const Split& split, Level... level) {
    if constexpr (std::is_function_v<Split> && sizeof...(level) == 0)
        if (split == split_in_half) return answer::build_in_half(order, first, boxes);
    return answer::build_node(order, first, boxes, std::cref(split), level...);
}

}  // namespace rt
