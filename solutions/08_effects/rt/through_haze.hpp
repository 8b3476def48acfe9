#pragma once
#include <rt/lens_and_haze.hpp>
#include <rt/transmittance.hpp>

namespace rt {

// The color that gets to the eye. If the type AnyHaze has a member `density`, the fraction
// exp(-density * distance()) of `color` gets through, and haze.color makes up the rest. distance()
// is a search, so it is called once at most; it may return infinity. If the density is 0 or the
// type has no such member, the result is `color` as it is, and distance() is not called. A plain
// `if` would not compile for types without the member.
template <class AnyHaze, class Distance>
Color through_haze(const AnyHaze& haze, Color color, const Distance& distance) {
    if constexpr (requires { haze.density; }) {
        if (!(haze.density > 0)) return color;
        const Real share = transmittance(haze.density, distance());
        return share * color + (1 - share) * haze.color;
    } else {
        return color;
    }
}

}  // namespace rt
