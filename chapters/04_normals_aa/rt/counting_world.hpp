#pragma once
#include <cstdint>
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>

namespace rt {

// A world that counts the rays traced through it (given). A world that nobody counts
// costs nothing extra.
template <class World>
struct CountingWorld {
    const World& world;
    std::uint64_t& rays;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        ++rays;
        return world.hit(ray, within);
    }
};

}  // namespace rt
