#pragma once
#include <rt/compiler.hpp>
#include <rt/vec3_of.hpp>

namespace rt {

// Several boxes side by side, and the parts of an interval in which a ray is in them (given): each
// number of a Box and of an Interval is a pack here. hit_box (07.1) takes them in the same way.
template <class Pack>
struct BoxPack {
    Vec3Of<Pack> low, high;
};
template <class Pack>
struct IntervalPack {
    Pack min, max;
};

template <class Number>
RT_INLINED Number along(const Vec3Of<Number>& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace rt
