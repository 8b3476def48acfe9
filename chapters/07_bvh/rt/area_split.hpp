#pragma once
#include <rt/split_by_area.hpp>
#include <span>

namespace rt {

// A split for build_node: split_by_area with this cost of the tests of both boxes (given). The best
// cost depends on the processor, the compiler and the shapes; docs/studies/07_bvh.md measures it.
struct AreaSplit {
    Real boxes_cost = 4;

    int operator()(std::span<int> order, std::span<const Box> boxes) const {
        return split_by_area(order, boxes, boxes_cost);
    }
};

}  // namespace rt
