#pragma once
#include <rt/real.hpp>

namespace rt {

// A point or an offset in a plane.
struct Vec2 {
    Real x = 0, y = 0;

    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

}  // namespace rt
