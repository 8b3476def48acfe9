#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/todo.hpp>
#include <rt/view.hpp>

namespace rt {

// Exercise 13.5. The view of frame 0 ... frames - 1 of a turntable: the camera goes once around the
// point that it looks at, about the direction `up`, from above counterclockwise. Frame 0 is `view`.
// There is 1 frame or more.
// Star: frame 0 is `view` bit for bit, and so is frame `frames`, 2 * `frames` and so on.
inline View turned_view(View view, int frame, int frames) {
    return rt::todo("13.5", view, frame, frames);
}

}  // namespace rt
