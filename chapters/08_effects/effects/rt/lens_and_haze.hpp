#pragma once
#include <rt/color.hpp>
#include <rt/interval.hpp>

// What is special about rays from the eye: the lens through which they leave, and the haze on their
// way to the first surface.

namespace rt {

// A lens instead of a pinhole (given). Whatever is at the distance of focus is sharp.
struct Lens {
    Real aperture = 0;        // the diameter of the lens, 0 or more; 0 is a pinhole
    Real focus_distance = 1;  // from the eye along the direction of view, greater than 0
};

// Haze that fills all space evenly (given): what is far away fades into the haze's color. In
// painting this is called aerial perspective. Haze counts only between the eye and the first
// surface, and not from bounce to bounce, so it needs no random number and adds no noise.
struct Haze {
    Real density = 0;  // the share of light that is lost per unit of length, if it is small
    Color color;       // the light from where haze hides everything
};

// A scene without haze. It has no members, so code that uses them does not compile for it.
struct NoHaze {};

// How far a ray gets before it meets a surface; infinity if it meets none. This takes a search of
// its own, because the path loop does not tell where its first ray ended.
template <class AnyWorld, class AnyRay>
Real distance_ahead(const AnyWorld& world, const AnyRay& ray) {
    const auto hit = world.hit(ray, Interval{0, infinity});
    return hit ? hit->t : infinity;
}

}  // namespace rt
