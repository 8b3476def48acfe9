#pragma once
#include <rt/color.hpp>

namespace rt {

// What becomes of a path that has made all of its bounces.
enum class PathEnd { in_sky, in_black, none };

// As if nothing stood in the way after the last bounce. Too bright, mostly by a little.
struct SkyEnding {
    template <class Random>
    PathEnd operator()(Color&, Random&) const {
        return PathEnd::in_sky;
    }
};

// As if no light came from there. Too dark.
struct BlackEnding {
    template <class Random>
    PathEnd operator()(Color&, Random&) const {
        return PathEnd::in_black;
    }
};

}  // namespace rt
