#pragma once
#include <rt/vec3.hpp>

namespace rt {

// The cross product: perpendicular to a and b, of length |a| |b| times the sine of the angle
// between them, along the thumb of the right hand when its fingers curl from a to b. Each component
// is accurate to 1.5 units in the last place, however nearly parallel a and b are, as long as no
// product overflows or underflows.
inline Vec3 cross(Vec3 a, Vec3 b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

}  // namespace rt
