#pragma once
#include <algorithm>
#include <cmath>
#include <rt/canvas.hpp>
#include <rt/color.hpp>
#include <rt/denoise_widths.hpp>
#include <rt/dot.hpp>
#include <rt/image.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 11.6. The weight of pixel b's light for pixel a; b is `across` and `down` pixels away.
// It is exp(-d / 2), where d is the sum of (distance / width)^2 for three distances, each with its
// own width: in the picture, sqrt(across^2 + down^2); between the albedos, as vectors of three
// channels; and between the normals. So a pixel's own light has weight 1, and the light of every
// other pixel less.
// Star: `across` and `down` may be negative or large. No square may overflow or vanish because a
// width is small. Source: Tomasi and Manduchi, "Bilateral filtering for gray and color images",
// ICCV 1998; with features instead of colors: Petschnigg et al., "Digital photography with flash
// and no-flash image pairs", SIGGRAPH 2004.
inline Real bilateral_weight(int across, int down, const Features& a, const Features& b,
                             const DenoiseWidths& widths) {
    return rt::todo("11.6", across, down, a, b, widths);
}

// The denoised picture. Each pixel a gets the average light of the pixels b at most `radius`
// columns and rows away: the sum of weight times light, divided by the sum of the weights. The
// light of b is, in each channel, its color divided by its albedo; the average is multiplied by the
// albedo of a. In both steps, an albedo less than `darkest` counts as `darkest`, but not in the
// weights. `features` is as large as the picture.
// Star: at the border of the picture, only pixels within it count, however large the radius. An
// albedo may be 0 or more than 1, and the light very bright or very dark.
inline Image denoised(const Image& picture, const Canvas<Features>& features,
                      const DenoiseWidths& widths) {
    return rt::todo("11.6", picture, features, widths);
}

}  // namespace rt
