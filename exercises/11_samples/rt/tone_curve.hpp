#pragma once
#include <cmath>
#include <rt/color.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.5. The same light with a longer or shorter exposure, as photographers count it: each
// stop doubles the light, each negative stop halves it, and half a stop is a factor of sqrt(2).
// stops is between -100 and 100.
inline Color exposed(const Color& color, Real stops) {
    return rt::todo("11.5", color, stops);
}

// How bright a color looks: the sum of its channels, weighted as the eye weights them, 0.2126 for
// red, 0.7152 for green and 0.0722 for blue. This holds for linear light, which a Color is.
// Source: ITU-R BT.709.
inline Real luminance(const Color& color) {
    return rt::todo("11.5", color);
}

// The brightness that a screen shows for a luminance, which is finite and not negative: L (1 + L /
// white^2) / (1 + L). Dark tones hardly change, and bright tones are compressed. `white` is greater
// than 0. A luminance of `white` becomes 1, and a brighter one more than 1.
// Star: if white is infinite, the curve is L / (1 + L), which never reaches 1. In float, a
// luminance may be from 1e-30 to 1e30, and white from 1e-25 to 1e30; in double, a luminance from
// 1e-200 to 1e200, and white from 1e-170 to 1e200. Even for the smallest white, a luminance of
// `white` becomes 1.
// Source: Reinhard, Stark, Shirley and Ferwerda, "Photographic tone reproduction for digital
// images", SIGGRAPH 2002.
inline Real tone_curve(Real luminance, Real white) {
    return rt::todo("11.5", luminance, white);
}

// The color with its luminance sent through the curve. All three channels get the same factor, so
// the hue stays the same; this may take one channel of a vivid color above 1.
// Star: black stays black.
inline Color tone_mapped(const Color& color, Real white) {
    return rt::todo("11.5", color, white);
}

}  // namespace rt
