#pragma once
// What chapter 12 computes in float, for a build in double.

#include <array>

namespace live {

// Three coordinates; each must be a number that float has.
struct Triple {
    double x = 0, y = 0, z = 0;
};

// For three corners each of two triangles: bit i is set if the ray hits triangle i.
struct EdgeHits {
    unsigned plain = 0;     // by the plain test of Möller and Trumbore
    unsigned exercise = 0;  // by hit_triangle
};
EdgeHits hits_in_float(const std::array<std::array<Triple, 3>, 2>& pair, Triple origin,
                       Triple direction);

}  // namespace live
