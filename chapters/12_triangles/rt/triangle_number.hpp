#pragma once
#include <rt/hit.hpp>

namespace rt {

// Which of a scene's triangles was hit (given). A triangle is no light, so a hit keeps the
// triangle's number in the member for a light's number, as a value below -1, which that member
// never has in a sphere's hit. A member of its own would make each hit of a sphere longer, too.
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
