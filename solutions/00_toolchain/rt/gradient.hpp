#pragma once
#include <rt/corners.hpp>

namespace rt {

// The color at one point of the picture: `across` runs from 0 at the left edge to 1 at the right
// edge, `down` from 0 at the top to 1 at the bottom. At a corner it is exactly the corner's color;
// in between it changes evenly along every row and every column. Its error is at most a few
// roundings of the result, even beside a corner that is a million times as bright.
//
// This line is a declaration: it ends in a semicolon and has no body. The body, the definition, is
// in gradient.cpp.
Color gradient(const Corners& corners, Real across, Real down);

}  // namespace rt
