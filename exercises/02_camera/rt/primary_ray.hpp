#pragma once
#include <rt/camera.hpp>
#include <rt/length.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 02.4. The ray from the eye through a point of a pixel; column, row and offset are those
// of pixel_to_viewport. The viewport is at distance 1 from the eye, along -w of camera.basis. The
// direction has length 1. The text derives the formula.
// Star: each of its components is within 7 epsilon, however far the eye is from the scene's origin.
inline Ray primary_ray(const Camera& camera, int column, int row, Vec2 offset) {
    return rt::todo("02.4", camera, column, row, offset);
}

}  // namespace rt
