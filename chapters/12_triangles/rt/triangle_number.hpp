#pragma once
#include <rt/hit.hpp>

namespace rt {

// The number of the triangle that was hit, among the scene's triangles (given). A triangle is no
// light, so a hit stores the triangle's number in `light`, the member for a light's number, as a
// value less than -1. In a sphere's hit, `light` never has such a value. A member of its own would
// also make every hit of a sphere larger.
constexpr int kept_as_light(int triangle) {
    return -2 - triangle;
}
constexpr bool is_triangle(const Hit& hit) {
    return hit.light < -1;
}
constexpr int triangle_number(const Hit& hit) {
    return -2 - hit.light;
}

}  // namespace rt
