#pragma once
#include <app/figure.hpp>

namespace app {

// Says that the next pixels to be drawn are those of this panel (given). Nobody needs to know, but
// the header that stands in for this one when `./course run --follow` looks for a pixel.
inline void begin_panel(const Figure&) {}

}  // namespace app
