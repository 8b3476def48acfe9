#pragma once
// The eight cameras of this chapter, and where each one's panel lies in the picture.

#include <algorithm>
#include <array>
#include <cstdint>
#include <rt/portable.hpp>
#include <rt/view.hpp>
#include <string_view>

#include "dome.hpp"

namespace panels {

struct Panel {
    std::string_view caption;
    rt::View view;
};

constexpr int columns = 4, rows = 2;

// In the upper row, only the field of view changes. Each panel of the lower row differs in one
// thing from the third panel of the upper row.
inline std::array<Panel, columns * rows> all() {
    using rt::Real, rt::Vec3;
    const Vec3 eye{0, Real(1.7), 0};
    const auto view = [&](Vec3 direction, Real fov_deg, Vec3 up = {0, 1, 0}) {
        return rt::View{eye, eye + direction, up, rt::radians(fov_deg)};
    };
    const Vec3 south = dome::toward(180, 7);
    const Vec3 tilted{rt::portable::sin(rt::radians(25)), rt::portable::cos(rt::radians(25)), 0};
    return {{{"FOV 20*", view(south, 20)},
             {"FOV 50*", view(south, 50)},
             {"FOV 90*", view(south, 90)},
             {"FOV 140*", view(south, 140)},
             {"Left 90*", view(dome::toward(90, 7), 90)},
             {"Up 40*", view(dome::toward(180, 47), 90)},
             {"Roll 25*", view(south, 90, tilted)},
             {"Straight up", view({0, 1, 0}, 90)}}};
}

// The pixels of one panel along one axis.
struct Span {
    int begin = 0, size = 1;
};

// Part i of n equal parts of these pixels, without the gutters on both sides if there is room for
// gutters. In an image with fewer pixels than parts, some parts are never shown.
inline Span part(int pixels, int i, int n) {
    const auto edge = [&](std::int64_t k) { return static_cast<int>(k * pixels / n); };
    const int size = std::max(edge(i + 1) - edge(i), 1), gutter = std::clamp((size - 1) / 2, 0, 2);
    return {edge(i) + gutter, size - 2 * gutter};
}

// The part to which a pixel belongs, gutters included.
inline int part_of(int pixel, int pixels, int n) {
    return static_cast<int>(((pixel + std::int64_t{1}) * n - 1) / pixels);
}

}  // namespace panels
