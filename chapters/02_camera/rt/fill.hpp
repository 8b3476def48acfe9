#pragma once
#include <app/figure.hpp>
#include <app/run.hpp>
#include <rt/for_each_pixel.hpp>

namespace app {

// Paints every pixel of a panel by the loop of exercise 02.5: shade(column, row) gives the color.
// Steps the progress with each row. Only programs use it, from chapter 02 on: if a library in
// common used it, that library would bring a loop of its own.
template <class Shade>
void fill(Figure panel, const Shade& shade, Progress* progress = nullptr) {
    const rt::Tile pixels = panel.pixels();
    rt::for_each_pixel(pixels, [&](int column, int row) {
        panel.set(column, row, shade(column, row));
        if (progress && column == pixels.right - 1) progress->step();
    });
}

}  // namespace app
