#pragma once
#include <algorithm>
#include <cmath>
#include <rt/canvas.hpp>
#include <rt/color.hpp>
#include <rt/dot.hpp>
#include <rt/image.hpp>

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

// What a pixel this far away counts for another one's light, in (0, 1]: the less, the farther it is
// and the more their surfaces differ. The pixel itself counts 1.
// Source: Tomasi and Manduchi, "Bilateral filtering for gray and color images", ICCV 1998; with
// features in place of colors: Petschnigg et al., "Digital photography with flash and no-flash
// image pairs", SIGGRAPH 2004.
inline Real bilateral_weight(int across, int down, const Features& a, const Features& b,
                             const DenoiseWidths& widths) {
    const Color albedo = a.albedo - b.albedo;
    const Vec3 normal = a.normal - b.normal;
    const Real x = static_cast<Real>(across) / widths.space;
    const Real y = static_cast<Real>(down) / widths.space;
    const Real color = (albedo.r * albedo.r + albedo.g * albedo.g + albedo.b * albedo.b) /
                       (widths.albedo * widths.albedo);
    const Real turn = dot(normal, normal) / (widths.normal * widths.normal);
    return std::exp(-(x * x + y * y + color + turn) / 2);
}

// The picture with each pixel's light averaged over those around it, by their weights. What is
// averaged is the light that falls on the surfaces, without their albedo, so that a texture stays
// as sharp as it is. Where a channel of the albedo is 0, the picture's own channel takes the place
// of the light.
inline Image denoised(const Image& picture, const Canvas<Features>& features,
                      const DenoiseWidths& widths) {
    const auto per = [](Real light, Real albedo) { return albedo > 0 ? light / albedo : light; };
    const auto times = [](Real light, Real albedo) { return albedo > 0 ? light * albedo : light; };
    Image smooth = Canvas<Color>(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const Features& here = features.at(x, y);
            Color sum;
            Real weights = 0;
            const int right = std::min(x + widths.radius, picture.width() - 1);
            const int bottom = std::min(y + widths.radius, picture.height() - 1);
            for (int j = std::max(y - widths.radius, 0); j <= bottom; ++j)
                for (int i = std::max(x - widths.radius, 0); i <= right; ++i) {
                    const Features& there = features.at(i, j);
                    const Color& light = picture.at(i, j);
                    const Real weight = bilateral_weight(i - x, j - y, here, there, widths);
                    sum +=
                        weight * Color{per(light.r, there.albedo.r), per(light.g, there.albedo.g),
                                       per(light.b, there.albedo.b)};
                    weights += weight;
                }
            const Color light = sum / weights;
            smooth.at(x, y) = {times(light.r, here.albedo.r), times(light.g, here.albedo.g),
                               times(light.b, here.albedo.b)};
        }
    return smooth;
}

}  // namespace rt
