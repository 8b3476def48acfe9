#pragma once
#include <cmath>
#include <rt/color.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.5. The same light with a longer or shorter exposure: each stop doubles it, each
// negative one halves it.
inline Color exposed(const Color& color, Real stops) {
    return rt::todo("11.5", color, stops);
}

// How bright a color looks: its channels, weighed as the eye weighs them. Source: ITU-R BT.709.
inline Real luminance(const Color& color) {
    return rt::todo("11.5", color);
}

// The brightness that a screen shows for a luminance, 0 or more: dark tones hardly change, bright
// ones are pressed together, and `white`, greater than 0, becomes 1. Infinite luminance gives
// infinity, unless white is infinite. Source: Reinhard, Stark, Shirley and Ferwerda, "Photographic
// tone reproduction for digital images", SIGGRAPH 2002.
inline Real tone_curve(Real luminance, Real white) {
    return rt::todo("11.5", luminance, white);
}

// The color with its luminance sent through the curve; its hue stays.
inline Color tone_mapped(const Color& color, Real white) {
    return rt::todo("11.5", color, white);
}

}  // namespace rt
