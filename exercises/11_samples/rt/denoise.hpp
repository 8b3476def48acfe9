#pragma once
#include <algorithm>
#include <cmath>
#include <rt/canvas.hpp>
#include <rt/color.hpp>
#include <rt/dot.hpp>
#include <rt/image.hpp>
#include <rt/todo.hpp>

namespace rt {

// What is known of a pixel without noise: the surface that its eye ray meets.
struct Features {
    Color albedo;
    Vec3 normal;  // 0 for the sky
};

// How far a pixel's light may spread. A distance of one width takes away 1 - exp(-1/2), 39 %, of
// the weight.
struct DenoiseWidths {
    int radius = 6;  // pixels; beyond it nothing counts
    Real space = 3;  // pixels
    Real albedo = Real(0.1);
    Real normal = Real(0.2);
};

// Exercise 11.6. What a pixel this far away counts for another one's light, in (0, 1]: the less,
// the farther it is and the more their surfaces differ. The pixel itself counts 1. Source: Tomasi
// and Manduchi, "Bilateral filtering for gray and color images", ICCV 1998; with features in place
// of colors: Petschnigg et al., "Digital photography with flash and no-flash image pairs", SIGGRAPH
// 2004.
inline Real bilateral_weight(int across, int down, const Features& a, const Features& b,
                             const DenoiseWidths& widths) {
    return rt::todo("11.6", across, down, a, b, widths);
}

// The picture with each pixel's light averaged over those around it, by their weights. What is
// averaged is the light that falls on the surfaces, without their albedo, so that a texture stays
// as sharp as it is. Where a channel of the albedo is 0, the picture's own channel takes the place
// of the light.
inline Image denoised(const Image& picture, const Canvas<Features>& features,
                      const DenoiseWidths& widths) {
    return rt::todo("11.6", picture, features, widths);
}

}  // namespace rt
