#pragma once
#include <rt/color.hpp>
#include <rt/interval.hpp>

namespace rt {

// Haze that fills all space evenly (given): what is far away fades into its color. In painting this
// is aerial perspective. It counts between the eye and the first surface alone, and not from bounce
// to bounce, so it needs no random number and adds no noise.
struct Haze {
    Real density = 0;  // the share of light that is lost per unit of length, where that is small
    Color color;       // the light that comes from where nothing can be seen for haze
};

// A scene without haze. It has no members, so code that uses them does not compile for it.
struct NoHaze {};

// How far a ray gets before it meets a surface; infinity if it meets none. A search of its own: the
// path loop does not tell where its first ray ended.
template <class World, class AnyRay>
Real distance_ahead(const World& world, const AnyRay& ray) {
    const auto hit = world.hit(ray, Interval{0, infinity});
    return hit ? hit->t : infinity;
}

}  // namespace rt
