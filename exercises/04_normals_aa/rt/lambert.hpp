#pragma once
#include <algorithm>
#include <rt/dot.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.2. The fraction of the light from a distant lamp that a surface gets: the cosine of
// the angle between the surface's normal and the direction to the light, and 0 where the surface
// faces away. Both vectors must have length 1.
// Star: however small the cosine is, the light is not lost.
// Source: Lambert, "Photometria", 1760.
inline Real lambert(Vec3 normal, Vec3 to_light) {
    return rt::todo("04.2", normal, to_light);
}

}  // namespace rt
