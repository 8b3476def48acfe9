#pragma once
#include <cstdint>

namespace rt {

// A point of the unit square. Each coordinate is stored as the 32 bits after its binary point:
// 0x80000000 is one half, 0x40000000 is a quarter, and x stands for the fraction x / 2^32.
struct FixedPoint2 {
    std::uint32_t x = 0, y = 0;

    friend constexpr bool operator==(const FixedPoint2&, const FixedPoint2&) = default;
};

}  // namespace rt
