#pragma once
#include <rt/camera.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 02.1. The point of the viewport that a pixel shows: x to the right, y up, (0, 0) in the
// middle, in the units of camera.viewport. column counts from 0 at the left to camera.width - 1,
// row from 0 at the top to camera.height - 1. offset in [0, 1] x [0, 1] is the point within the
// pixel, from its top left corner: (0.5, 0.5) is its middle. The text derives the formula.
// Star: both results are within 3 units in the last place.
inline Vec2 pixel_to_viewport(const Camera& camera, int column, int row, Vec2 offset) {
    return rt::todo("02.1", camera, column, row, offset);
}

}  // namespace rt
