#pragma once
#include <rt/corners.hpp>

namespace rt {

// The color at one point of the picture: `across` runs from 0 at the left edge to 1 at the right
// edge, `down` from 0 at the top to 1 at the bottom. At a corner, the result is the corner's color;
// in between, the color changes evenly along every row and every column. This line is a
// declaration: it ends in a semicolon and has no body. The definition, which has the body, is in
// gradient.cpp.
// Star: the error is at most a few roundings of the result, even if one corner is a million times
// as bright as the result. At a corner, the result is exactly the corner's color.
Color gradient(const Corners& corners, Real across, Real down);

}  // namespace rt
