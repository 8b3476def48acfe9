#pragma once
#include <array>
#include <cmath>
#include <rt/image.hpp>
#include <rt/vec2.hpp>

namespace rt {

// Two neighboring pixels, and the weight of the second pixel when their colors are mixed.
struct PixelPair {
    std::array<int, 2> pixel{};
    Real share;
};

// The pair of pixels around `u`, where the range [0, 1] is a side of the image, `count` pixels
// long. Outside of this range, the image repeats.
inline PixelPair pixels_at(Real u, int count) {
    const Real within = (u - std::floor(u)) * static_cast<Real>(count) - Real(0.5);
    const Real first = std::floor(within);  // -1 or more
    const int before = static_cast<int>(first) + count;
    return {{before % count, (before + 1) % count}, within - first};
}

// The color at a position in an image, `uv`: the mean of the four pixels around it, weighted by
// how near their middles are. (0, 0) is the image's lower left corner, (1, 1) the upper right
// corner; outside, the image repeats. The coordinates must be finite.
inline Color bilinear(const Image& image, Vec2 uv) {
    const PixelPair x = pixels_at(uv.x, image.width()), y = pixels_at(1 - uv.y, image.height());
    const auto row = [&](std::size_t k) {
        return mix(image.at(x.pixel[0], y.pixel[k]), image.at(x.pixel[1], y.pixel[k]), x.share);
    };
    return mix(row(0), row(1), y.share);
}

}  // namespace rt
