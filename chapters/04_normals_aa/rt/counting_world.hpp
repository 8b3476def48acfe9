#pragma once
#include <cstdint>
#include <rt/world.hpp>

namespace rt {

// A world that counts the rays traced through it (given). Where no rays are counted, this costs
// nothing.
template <World AnyWorld>
struct CountingWorld {
    const AnyWorld& world;
    std::uint64_t& rays;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        ++rays;
        return world.hit(ray, within);
    }
    // Shadow rays, from chapter 08 on, are counted, too.
    template <class AnyRay>
    bool occluded(const AnyRay& ray, Interval within, int number) const {
        ++rays;
        return world.occluded(ray, within, number);
    }
};

}  // namespace rt
