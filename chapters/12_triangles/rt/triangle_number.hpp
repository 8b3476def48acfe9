#pragma once
#include <rt/hit.hpp>

namespace rt {

// Which of a scene's triangles was hit (given). A triangle is no light, so a hit keeps its number
// where it would keep a light's: below -1, which a sphere's hit never has. A member of its own
// would make each hit of a sphere longer, too.
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
