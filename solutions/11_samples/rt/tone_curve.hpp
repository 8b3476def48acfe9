#pragma once
#include <rt/color.hpp>
#include <rt/portable.hpp>

namespace rt {

// The same light with a longer or shorter exposure, as photographers count it: each stop doubles
// the light, each negative stop halves it, and half a stop is a factor of sqrt(2). stops is between
// -100 and 100.
inline Color exposed(const Color& color, Real stops) {
    return color * portable::exp2(stops);
}

// How bright a color looks: the sum of its channels, weighted as the eye weights them, 0.2126 for
// red, 0.7152 for green and 0.0722 for blue. This holds for linear light, which a Color is.
// Source: ITU-R BT.709.
inline Real luminance(const Color& color) {
    return Real(0.2126) * color.r + Real(0.7152) * color.g + Real(0.0722) * color.b;
}

// The brightness that a screen shows for a luminance, which is finite and not negative: L (1 + L /
// white^2) / (1 + L). Dark tones hardly change, and bright tones are compressed. A luminance of
// `white`, greater than 0, becomes 1, and a greater luminance more than 1. If white is infinite,
// the curve is L / (1 + L), which never reaches 1. In float, a luminance may be from 1e-30 to 1e30,
// and white from 1e-25 to 1e30; in double, a luminance from 1e-200 to 1e200, and white from 1e-170
// to 1e200. Even for the smallest white, a luminance of `white` becomes 1.
// Source: Reinhard, Stark, Shirley and Ferwerda, "Photographic tone reproduction for digital
// images", SIGGRAPH 2002.
inline Real tone_curve(Real luminance, Real white) {
    const Real pressed = luminance / (1 + luminance);
    return pressed + pressed / white * (luminance / white);
}

// The color with its luminance sent through the curve. All three channels get the same factor, so
// the hue stays the same; this may take one channel of a vivid color above 1. Black stays black.
inline Color tone_mapped(const Color& color, Real white) {
    const Real before = luminance(color);
    if (!(before > 0)) return {};
    return color / before * tone_curve(before, white);
}

}  // namespace rt
