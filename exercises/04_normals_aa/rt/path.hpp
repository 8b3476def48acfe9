#pragma once
#include <optional>
#include <rt/color.hpp>
#include <rt/ending.hpp>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/leave_surface.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 04.7. The light that comes back along a ray. The path is followed from bounce to bounce
// until it meets the sky, is absorbed, or is ended by `ending`, which is called after bounce number
// `depth` (at least 1) and after every later bounce. Every hit counts, at any t from 0 to infinity,
// and so does all light, however dim. leave_surface is the one from 04.6. The types of the
// arguments are template parameters; the steps in the text say what each type must be able to do.
// Star: a scene gives the same picture at any scale.
template <class AnyRay, class World, class Materials, class Sky, class Ending, class Random>
Color path_radiance(AnyRay ray, const World& world, const Materials& materials, const Sky& sky,
                    const Ending& ending, int depth, Random& random) {
    return rt::todo("04.7", ray, world, materials, sky, ending, depth, random);
}

}  // namespace rt
