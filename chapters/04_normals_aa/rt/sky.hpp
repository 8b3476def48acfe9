#pragma once
#include <algorithm>
#include <rt/color.hpp>
#include <rt/vec3.hpp>

namespace rt {

// The same light from all directions (given), as in furnace tests.
struct UniformSky {
    Color color{1, 1, 1};

    constexpr Color operator()(Vec3) const { return color; }
};

// A sky that changes from one color straight below to another straight above (given). Directions
// have length 1.
struct GradientSky {
    Color below, above;

    constexpr Color operator()(Vec3 direction) const {
        // Rounding may leave a computed y a little beyond 1, and light is never negative.
        return mix(below, above, std::clamp((direction.y + 1) / 2, Real(0), Real(1)));
    }
};

}  // namespace rt
