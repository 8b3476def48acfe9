#pragma once
// Denoises a picture that was drawn in two halves. The halves alone tell how wide the filter should
// be, and how far off the result is.

#include <algorithm>
#include <array>
#include <cmath>
#include <rt/canvas.hpp>
#include <rt/denoise.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/halves.hpp>
#include <rt/image.hpp>
#include <rt/twin_halves.hpp>

namespace samples {

using namespace rt;

// An estimate of the square error of the mean of the filtered halves, in one channel of a pixel.
// The filter must be linear, as denoised() is: this mean is then the filtered picture. The error
// after filtering is the change that the filter makes, plus the noise before filtering. The noise
// before filtering is estimated as half the difference of the halves, and the noise after filtering
// as half the difference of the filtered halves. The estimate is unbiased if the halves err
// independently. For a single pixel the estimate says little, and may be negative.
inline Real filtered_square_error(Halves<Real> half, Halves<Real> filtered) {
    const Real change = twin_mean(filtered) - twin_mean(half);
    const Real noise = (half.first - half.second) / 2;
    const Real left = (filtered.first - filtered.second) / 2;
    return change * change - noise * (noise - 2 * left);
}

struct Denoised {
    Image picture;
    Real error = infinity;  // root mean square over all channels, estimated
};

// Tries the usual widths, half of them, a quarter of them, and no filter. Each pixel gets the
// result whose error, estimated over the pixels around it, is smallest. Since the smallest
// estimates are chosen, the true error is a bit larger than the estimated error.
inline Denoised denoise_halves(const Halves<Image>& half, const Canvas<Features>& features) {
    const int width = features.width(), height = features.height();
    const Tile all{0, 0, width, height};
    constexpr std::array<Real, 4> factors{1, Real(0.5), Real(0.25), 0};
    struct Trial {
        Image picture;
        Canvas<Real> squares;  // the sum of the channels' square errors
    };
    const auto try_out = [&](Real factor) {
        const DenoiseWidths usual;
        const DenoiseWidths widths{
            static_cast<int>(std::ceil(static_cast<Real>(usual.radius) * factor)),
            usual.space * factor, usual.albedo * factor, usual.normal * factor, usual.darkest};
        const Halves<Image> filtered = factor > 0
                                           ? Halves<Image>{denoised(half.first, features, widths),
                                                           denoised(half.second, features, widths)}
                                           : half;
        Trial trial{Canvas<Color>{width, height}, {width, height}};
        for_each_pixel(all, [&](int x, int y) {
            for (const auto channel : {&Color::r, &Color::g, &Color::b}) {
                const auto at = [&](const Halves<Image>& in) {
                    return Halves<Real>{in.first.at(x, y).*channel, in.second.at(x, y).*channel};
                };
                trial.picture.at(x, y).*channel = twin_mean(at(filtered));
                trial.squares.at(x, y) += filtered_square_error(at(half), at(filtered));
            }
        });
        return trial;
    };

    Denoised best{Canvas<Color>{width, height}};
    Canvas<Real> least{width, height, infinity}, chosen{width, height};
    for (const Real factor : factors) {
        const Trial trial = try_out(factor);
        for_each_pixel(all, [&](int x, int y) {
            const int reach = DenoiseWidths{}.radius;
            Real around = 0;
            for_each_pixel({std::max(x - reach, 0), std::max(y - reach, 0),
                            std::min(x + reach + 1, width), std::min(y + reach + 1, height)},
                           [&](int i, int j) { around += trial.squares.at(i, j); });
            if (!(around < least.at(x, y))) return;
            least.at(x, y) = around;
            chosen.at(x, y) = trial.squares.at(x, y);
            best.picture.at(x, y) = trial.picture.at(x, y);
        });
    }
    double sum = 0;
    for (const Real square : chosen) sum += static_cast<double>(square);
    best.error =
        static_cast<Real>(std::sqrt(std::max(sum, 0.0) / (3 * static_cast<double>(chosen.size()))));
    return best;
}

}  // namespace samples
