#pragma once
#include <rt/length.hpp>
#include <rt/lens.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.2. The ray through a point of a pixel (see primary_ray) from a point of the lens, a
// disk around the eye that faces the direction of view. `place`, a sample point of the unit square,
// 0 <= x, y < 1, chooses the point of the lens: if sample points are equally likely all over the
// square, so must the points be all over the lens. All rays through one point of the picture meet
// in the plane of focus, at focus_distance in front of the eye. The direction has length 1. place.x
// is the share of the lens's area that is nearer to its middle than the chosen point: 0 gives the
// ray of primary_ray. place.y is the share of a turn around the middle, starting wherever you like,
// in either direction.
// Source: the thin lens; Cook, Porter and Carpenter, "Distributed ray tracing", SIGGRAPH 1984.
inline Ray lens_ray(const Camera& camera, const Lens& lens, int column, int row, Vec2 offset,
                    Vec2 place) {
    return rt::todo("08.2", camera, lens, column, row, offset, place);
}

}  // namespace rt
