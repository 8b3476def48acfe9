#pragma once
#include <rt/color.hpp>

namespace rt {

// What becomes of a path that has made all of its bounces.
enum class Fate { ends_in_sky, ends_in_black, goes_on };

// As if nothing stood in the way after the last bounce. Too bright, mostly by a little.
struct SkyEnding {
    template <class Random>
    Fate operator()(Color&, Random&) const {
        return Fate::ends_in_sky;
    }
};

// As if no light came from there. Too dark.
struct BlackEnding {
    template <class Random>
    Fate operator()(Color&, Random&) const {
        return Fate::ends_in_black;
    }
};

}  // namespace rt
