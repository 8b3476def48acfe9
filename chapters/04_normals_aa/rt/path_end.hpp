#pragma once
#include <rt/color.hpp>

namespace rt {

// What becomes of a path that has made all of its bounces.
enum class PathEnd { in_sky, in_black, none };

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
