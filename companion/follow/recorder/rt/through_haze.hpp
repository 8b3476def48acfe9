#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define through_haze through_haze_unfollowed
#include_next <rt/through_haze.hpp>
#undef through_haze
#include <rt/trail.hpp>

namespace rt {

template <class AnyHaze, class Distance>
Color through_haze(const AnyHaze& haze, Color color, const Distance& distance) {
    const Color seen = through_haze_unfollowed(haze, color, distance);
    if constexpr (requires { haze.density; })
        if (follow::here.in_sample) follow::trail().step("haze", "color", seen);
    return seen;
}

}  // namespace rt
