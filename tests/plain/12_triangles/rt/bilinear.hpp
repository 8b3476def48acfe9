#pragma once
#include <cmath>
#include <rt/image.hpp>
#include <rt/vec2.hpp>

namespace rt {

inline Color bilinear(const Image& image, Vec2 uv) {
    const int width = image.width(), height = image.height();
    const Real x = uv.x * static_cast<Real>(width) - Real(0.5);
    const Real y = (1 - uv.y) * static_cast<Real>(height) - Real(0.5);
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const auto pixel = [&](int right, int down) {
        const int c = ((column + right) % width + width) % width;
        const int r = ((row + down) % height + height) % height;
        return image.at(c, r);
    };
    const Real share_x = x - std::floor(x), share_y = y - std::floor(y);
    return mix(mix(pixel(0, 0), pixel(1, 0), share_x), mix(pixel(0, 1), pixel(1, 1), share_x),
               share_y);
}

}  // namespace rt
