#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define for_each_pixel for_each_pixel_unfollowed
#include_next <rt/for_each_pixel.hpp>
#undef for_each_pixel
#include <rt/trail.hpp>

namespace rt {

// Visits the pixel that is followed, and no other.
template <class Visit>
void for_each_pixel(const Tile& tile, Visit visit) {
    for_each_pixel_unfollowed(tile, [&](int column, int row) {
        if (!follow::trail().is_wanted(column, row)) return;
        follow::here = {.in_pixel = true};
        visit(column, row);
        follow::here.in_pixel = false;
        if (follow::here.samples == 0) return;
        follow::trail().step("pixel", "samples", follow::here.samples);
        follow::trail().end();
    });
}

}  // namespace rt
