#pragma once
#include <rt/length.hpp>
#include <rt/lens.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.2. The ray through a place of a pixel (see primary_ray) from a place of the lens,
// which is given in the unit square, 0 <= x, y < 1, where all places are equally likely: so they
// shall be on the lens, a disk around the eye that faces the direction of view. All rays of one
// place of the picture meet in the plane of focus, at focus_distance before the eye. The direction
// has length 1. place.x is the share of the lens's area that is nearer to its middle than the
// place: for 0 it is the ray of primary_ray. place.y is the share of a turn around the middle, from
// wherever you like, to either side.
// Source: the thin lens; Cook, Porter and Carpenter, "Distributed ray tracing", SIGGRAPH 1984.
inline Ray lens_ray(const Camera& camera, const Lens& lens, int column, int row, Vec2 offset,
                    Vec2 place) {
    return rt::todo("08.2", camera, lens, column, row, offset, place);
}

}  // namespace rt
