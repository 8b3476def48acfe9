#pragma once
#include <rt/length.hpp>
#include <rt/lens_and_haze.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.2. The ray from a point of the lens, a disk around the eye that faces the direction
// of view, through a point of a pixel (see primary_ray), by the formulas of the text. `place`, 0 <=
// x, y < 1, chooses the point of the lens: x is the fraction of its area that is nearer to its
// center than this point, y the fraction of a turn around the center, counted from any direction.
// The result's direction has length 1.
// Star: the ray is accurate for lenses of any size, even of aperture 0, which is a pinhole; at any
// distance of focus; and at any distance from the scene's origin.
// Source: the thin lens; Cook, Porter and Carpenter, "Distributed ray tracing", SIGGRAPH 1984.
inline Ray lens_ray(const Camera& camera, const Lens& lens, int column, int row, Vec2 offset,
                    Vec2 place) {
    return rt::todo("08.2", camera, lens, column, row, offset, place);
}

}  // namespace rt
