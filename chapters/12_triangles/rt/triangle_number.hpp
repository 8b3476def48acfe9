#pragma once
#include <rt/hit.hpp>

namespace rt {

// The number of the triangle that was hit, among the scene's triangles (given). A hit stores it in
// `light`, the member for the number of a sphere that is a light, as a value less than -1, which
// `light` never has in a sphere's hit. A member of its own would make every hit of a sphere larger.
// A triangle that shines is found by this number, too.
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
