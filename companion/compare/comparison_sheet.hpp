#pragma once
#include <companion/compare/comparison.hpp>
#include <rt/image.hpp>

namespace companion {

// Both pictures side by side, and the solution's picture in gray under a heat map: orange where
// yours is too bright, blue where it is too dark, violet where its color or noise differs.
rt::Image comparison_sheet(const Comparison& comparison);

// The third of these alone, for two pictures of the same size: the difference of each pixel.
rt::Image difference_map(const Picture& mine, const Picture& solution);

// Two pictures of the same size side by side, the learner's on the left.
rt::Image side_by_side(const rt::Image& mine, const rt::Image& ours);

}  // namespace companion
