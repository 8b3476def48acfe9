#pragma once
#include <array>
#include <cstddef>
#include <rt/compiler.hpp>

namespace rt {

// The children of a node that a ray meets (given), at most `most` of them: the one whose box the
// ray enters first comes first. A Child has the t of its `entry`, and node(), the node itself.
template <class Child, std::size_t most>
class NearestFirst {
  public:
    // Inserts a child. If the ray enters two boxes at the same t, they stay in the order in which
    // they were added.
    RT_INLINED void add(const Child& child) {
        std::size_t place = count_++;
        for (; place > 0 && child.entry < children_[place - 1].entry; --place)
            children_[place] = children_[place - 1];
        children_[place] = child;
    }
    const Child* begin() const { return children_.data(); }
    const Child* end() const { return children_.data() + count_; }

  private:
    std::array<Child, most> children_;
    std::size_t count_ = 0;
};

}  // namespace rt
