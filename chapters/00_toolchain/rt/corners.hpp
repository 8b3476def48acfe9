#pragma once
#include <rt/color.hpp>

namespace rt {

// The colors in the four corners of a picture.
struct Corners {
    Color top_left, top_right, bottom_left, bottom_right;
};

}  // namespace rt
