#pragma once
#include <app/figure.hpp>
#include <app/run.hpp>
#include <rt/for_each_pixel.hpp>
#include <rt/panel.hpp>

namespace app {

// Paints every pixel of a panel with the loop of exercise 02.5: shade(column, row) gives the color.
// Advances the progress with each row. Only programs use it, from chapter 02 on: a library in
// common/ that used it would contain its own compiled copy of the loop.
template <class Shade>
void fill(Figure panel, const Shade& shade, Progress* progress = nullptr) {
    const rt::Tile pixels = panel.pixels();
    begin_panel(panel);
    rt::for_each_pixel(pixels, [&](int column, int row) {
        panel.set(column, row, shade(column, row));
        if (progress && column == pixels.right - 1) progress->step();
    });
}

}  // namespace app
