#pragma once
#include <ostream>
#include <rt/real.hpp>

namespace rt {

// A point or an offset in a plane.
struct Vec2 {
    Real x = 0, y = 0;

    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;

    friend std::ostream& operator<<(std::ostream& out, Vec2 p) {
        return out << '(' << p.x << ", " << p.y << ')';
    }
};

}  // namespace rt
