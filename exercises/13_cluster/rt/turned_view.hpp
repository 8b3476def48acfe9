#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/todo.hpp>
#include <rt/view.hpp>

namespace rt {

// Exercise 13.5. The view in one frame of a turntable; `frame` goes from 0 to frames - 1. The
// camera goes once around the point that it looks at, about the direction `up`, counterclockwise as
// seen from above. Frame 0 is `view`. There is 1 frame or more.
// Star: every frame whose number is 0 or another multiple of `frames` is `view`, bit for bit.
inline View turned_view(View view, int frame, int frames) {
    return rt::todo("13.5", view, frame, frames);
}

}  // namespace rt
