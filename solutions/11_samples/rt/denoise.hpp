#pragma once
#include <algorithm>
#include <cmath>
#include <rt/canvas.hpp>
#include <rt/color.hpp>
#include <rt/denoise_widths.hpp>
#include <rt/dot.hpp>
#include <rt/image.hpp>
#include <rt/portable.hpp>

namespace rt {

// The weight of pixel b's light for pixel a; b is `across` and `down` pixels away (each may be
// negative, or large). It is exp(-d / 2), where d is the sum of the squares of three distances,
// each divided by its width before it is squared: in the picture, sqrt(across^2 + down^2); between
// the albedos, as vectors of three channels; and between the normals. So a pixel has weight 1 for
// itself. The farther away another pixel is, and the more its surface differs, the less weight it
// has. No square may overflow or vanish because a width is small. Source: Tomasi and Manduchi,
// "Bilateral filtering for gray and color images", ICCV 1998; with features instead of colors:
// Petschnigg et al., "Digital photography with flash and no-flash image pairs", SIGGRAPH 2004.
inline Real bilateral_weight(int across, int down, const Features& a, const Features& b,
                             const DenoiseWidths& widths) {
    // Divides before squaring.
    const Real x = static_cast<Real>(across) / widths.space;
    const Real y = static_cast<Real>(down) / widths.space;
    const Color albedo = (a.albedo - b.albedo) / widths.albedo;
    const Vec3 normal = (a.normal - b.normal) / widths.normal;
    const Real color = albedo.r * albedo.r + albedo.g * albedo.g + albedo.b * albedo.b;
    return portable::exp(-(x * x + y * y + color + dot(normal, normal)) / 2);
}

// The denoised picture. Each pixel a gets the average light of the pixels b at most `radius`
// columns and rows away, including itself: the sum of weight times light, divided by the sum of the
// weights. At the border of the picture there are fewer such pixels.
//
// The light of b is the light that falls on its surface: in each channel, its color divided by its
// albedo. The average is multiplied by the albedo of a, so a texture stays sharp. In both steps, an
// albedo less than `darkest` counts as `darkest`: there is no division by 0, and the little light
// that a dark surface reflects cannot make its neighbors bright. In the weights, albedos are not
// changed. `features` is as large as the picture.
inline Image denoised(const Image& picture, const Canvas<Features>& features,
                      const DenoiseWidths& widths) {
    const auto divisor = [&](const Color& albedo) {
        return Color{std::max(albedo.r, widths.darkest), std::max(albedo.g, widths.darkest),
                     std::max(albedo.b, widths.darkest)};
    };
    Canvas<Color> smooth(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const Features& here = features.at(x, y);
            Color sum;
            Real weights = 0;
            // The radius is compared with the distance to the border, because x + radius may
            // overflow.
            const int right = x + std::min(widths.radius, picture.width() - 1 - x);
            const int bottom = y + std::min(widths.radius, picture.height() - 1 - y);
            for (int j = std::max(y - widths.radius, 0); j <= bottom; ++j)
                for (int i = std::max(x - widths.radius, 0); i <= right; ++i) {
                    const Features& there = features.at(i, j);
                    const Color& light = picture.at(i, j);
                    const Color albedo = divisor(there.albedo);
                    const Real weight = bilateral_weight(i - x, j - y, here, there, widths);
                    sum +=
                        weight * Color{light.r / albedo.r, light.g / albedo.g, light.b / albedo.b};
                    weights += weight;
                }
            smooth.at(x, y) = sum / weights * divisor(here.albedo);
        }
    return smooth;
}

}  // namespace rt
