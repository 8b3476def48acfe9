#pragma once
#include <cstdint>

namespace rt {

// A child of a wide node (given): another node or a leaf, stored as its number among all nodes or
// all leaves of the tree. One integer stands for either, so that a node fits into few cache lines.
class WideChild {
  public:
    // Sets no value: a search's stack is an array of children, most of which are never used.
    WideChild() = default;
    static constexpr WideChild node(std::int32_t number) { return WideChild{number}; }
    static constexpr WideChild leaf(std::int32_t number) { return WideChild{~number}; }

    constexpr bool is_leaf() const { return code_ < 0; }
    constexpr std::int32_t number() const { return is_leaf() ? ~code_ : code_; }

    friend constexpr bool operator==(const WideChild&, const WideChild&) = default;

  private:
    constexpr explicit WideChild(std::int32_t code) : code_{code} {}

    std::int32_t code_;  // a node's number, or ~number of a leaf, which is negative
};

}  // namespace rt
