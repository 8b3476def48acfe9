#pragma once
#include <rt/vec3_type.hpp>

namespace rt {

// Where a camera stands and what it sees, as a person describes it.
struct View {
    Vec3 from{0, 0, 0};
    Vec3 at{0, 0, -1};           // the point in the middle of the picture
    Vec3 up{0, 1, 0};            // what points up in the picture; any length but 0
    Real vertical_fov = pi / 2;  // radians, between 0 and pi: from the lower to the upper edge
};

}  // namespace rt
