#pragma once
#include <array>
#include <cmath>
#include <rt/image.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Two pixels side by side, and the weight of the second in a color between their middles.
struct PixelPair {
    std::array<int, 2> pixel{};
    Real share;
};

// The pair for a position along a side of this many pixels. Outside of [0, 1] the side repeats.
inline PixelPair pixels_at(Real place, int count) {
    const Real within = (place - std::floor(place)) * static_cast<Real>(count) - Real(0.5);
    const Real first = std::floor(within);  // from -1 on
    const int before = static_cast<int>(first) + count;
    return {{before % count, (before + 1) % count}, within - first};
}

// The color at a position in an image, `place`: the mean of the four pixels around it, weighted by
// how near their middles are. (0, 0) is the lower left corner, (1, 1) the upper right corner;
// outside, the image repeats. The coordinates must be finite.
inline Color bilinear(const Image& image, Vec2 place) {
    const PixelPair x = pixels_at(place.x, image.width()),
                    y = pixels_at(1 - place.y, image.height());
    const auto row = [&](std::size_t k) {
        return mix(image.at(x.pixel[0], y.pixel[k]), image.at(x.pixel[1], y.pixel[k]), x.share);
    };
    return mix(row(0), row(1), y.share);
}

}  // namespace rt
