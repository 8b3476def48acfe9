#pragma once
#include <ostream>
#include <rt/real.hpp>

namespace rt {

// A vector or a point in space: right-handed coordinates, y up. Its operations are in
// <rt/vec3.hpp>.
struct Vec3 {
    Real x = 0, y = 0, z = 0;

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;

    friend std::ostream& operator<<(std::ostream& out, Vec3 v) {
        return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
    }
};

}  // namespace rt
