#pragma once
#include <concepts>
#include <rt/color.hpp>
#include <rt/rng.hpp>

namespace rt {

// What becomes of a path that has made all of its bounces.
enum class PathEnd { in_sky, in_black, none };

// What decides about such a path (given). It may change the throughput of a path that goes on.
template <class Type, class Random = Rng>
concept Ending = requires(const Type& ending, Color& throughput, Random& random) {
    { ending(throughput, random) } -> std::same_as<PathEnd>;
};

// Ends paths in the sky, as if nothing stood in the way after the last bounce. The picture becomes
// too bright, usually only a little.
struct SkyEnding {
    template <class Random>
    PathEnd operator()(Color&, Random&) const {
        return PathEnd::in_sky;
    }
};

// Ends paths in black, as if no light came after the last bounce. The picture becomes too dark.
struct BlackEnding {
    template <class Random>
    PathEnd operator()(Color&, Random&) const {
        return PathEnd::in_black;
    }
};

}  // namespace rt
