#pragma once
#include <algorithm>
#include <rt/vec3.hpp>

namespace rt {

// The component of a vector along axis 0, 1 or 2: x, y or z.
constexpr Real along(Vec3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// A box with faces along the axes: all points from low to high, faces included. Box{} is the empty
// box: it contains nothing, and joining it with another box gives that box.
struct Box {
    Vec3 low{infinity, infinity, infinity};
    Vec3 high{-infinity, -infinity, -infinity};

    friend constexpr bool operator==(const Box&, const Box&) = default;

    constexpr bool is_empty() const {
        return !(low.x <= high.x && low.y <= high.y && low.z <= high.z);
    }
    constexpr bool contains(Vec3 p) const {
        return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z &&
               p.z <= high.z;
    }
    // The empty box lies within every box.
    constexpr bool contains(const Box& box) const {
        return box.is_empty() || (contains(box.low) && contains(box.high));
    }
    Vec3 size() const { return is_empty() ? Vec3{} : high - low; }
    Vec3 center() const { return Real(0.5) * low + Real(0.5) * high; }
};

// The axis along which a box is longest.
inline int longest_axis(const Box& box) {
    const Vec3 size = box.size();
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

}  // namespace rt
