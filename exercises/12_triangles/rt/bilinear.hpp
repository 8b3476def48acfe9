#pragma once
#include <array>
#include <cmath>
#include <rt/image.hpp>
#include <rt/todo.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Exercise 12.6. The color of an image at a place: the four pixels around it, each weighted by
// how near its middle is. (0, 0) is the image's lower left corner, (1, 1) the upper right one.
// The image repeats in all directions: right of the last column the first one follows.
// Star: the place may be any finite numbers, however large or small.
inline Color bilinear(const Image& image, Vec2 place) {
    return rt::todo("12.6", image, place);
}

}  // namespace rt
