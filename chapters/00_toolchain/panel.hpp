#pragma once
// What all panels of the figure share: their colors, and the dark glass that they are drawn on.

#include <app/figure.hpp>
#include <string_view>

namespace toolchain {

using namespace rt;
using app::Figure;

inline const Color ink = from_hex(0xfff4e0), faint = from_hex(0xe2d6ee), glass = from_hex(0x0c0a1c),
                   gold = from_hex(0xffd166), rose = from_hex(0xff6b8b), mint = from_hex(0x6ee7c8),
                   sky_blue = from_hex(0x7cc6fe);

inline void draw_panel(Figure& figure, const app::Box& box, std::string_view title) {
    figure.box(box, glass, Real(0.84), 8);
    figure.frame(box, ink, Real(0.16), 8);
    figure.words({box.left + 12, box.top + 11}, title, {8, ink});
}

}  // namespace toolchain
