#pragma once
#include <array>
#include <cmath>
#include <rt/image.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 12.6. The color at a position in an image, `uv`: the mean of the four pixels around
// it, weighted by how near their middles are. (0, 0) is the image's lower left corner, (1, 1) the
// upper right corner. The image repeats in all directions: the first column follows the last one.
// Star: the coordinates may be any finite numbers, however large or small.
inline Color bilinear(const Image& image, Vec2 uv) {
    return rt::todo("12.6", image, uv);
}

}  // namespace rt
