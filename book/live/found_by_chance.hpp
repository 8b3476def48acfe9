#pragma once
#include <rt/lights.hpp>

namespace live {

// The lights of a scene for paths that find them only by chance: they say that there are none to
// sample.
struct FoundByChance : rt::SceneLights {
    static constexpr bool empty() { return true; }
};

}  // namespace live
