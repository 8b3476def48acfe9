#pragma once
#include <rt/color.hpp>
#include <rt/vec3.hpp>

namespace rt {

// The same light from everywhere (given): what furnace tests are lit by.
struct UniformSky {
    Color color{1, 1, 1};

    constexpr Color operator()(Vec3) const { return color; }
};

// From one color straight below to another straight above (given). Directions have length 1.
struct GradientSky {
    Color below, above;

    constexpr Color operator()(Vec3 direction) const {
        return mix(below, above, (direction.y + 1) / 2);
    }
};

}  // namespace rt
