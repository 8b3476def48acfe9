#pragma once
#include <cmath>
#include <rt/color.hpp>

namespace rt {

// The same light with a longer or shorter exposure: each stop doubles it, each negative one halves
// it.
inline Color exposed(const Color& color, Real stops) {
    return color * std::exp2(stops);
}

// How bright a color looks: its channels, weighed as the eye weighs them. Source: ITU-R BT.709.
inline Real luminance(const Color& color) {
    return Real(0.2126) * color.r + Real(0.7152) * color.g + Real(0.0722) * color.b;
}

// The brightness that a screen shows for a luminance, 0 or more: dark tones hardly change, bright
// ones are pressed together, and `white`, greater than 0, becomes 1. Infinite luminance gives
// infinity, unless white is infinite. Source: Reinhard, Stark, Shirley and Ferwerda, "Photographic
// tone reproduction for digital images", SIGGRAPH 2002.
inline Real tone_curve(Real luminance, Real white) {
    // L (1 + L / white^2) / (1 + L), with no square that could overflow.
    const Real pressed = luminance == infinity ? Real(1) : luminance / (1 + luminance);
    return pressed * (1 + luminance / white / white);
}

// The color with its luminance sent through the curve; its hue stays.
inline Color tone_mapped(const Color& color, Real white) {
    const Real before = luminance(color);
    if (!(before > 0)) return {};
    return color * (tone_curve(before, white) / before);
}

}  // namespace rt
