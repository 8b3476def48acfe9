#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/todo.hpp>
#include <rt/view.hpp>

namespace rt {

// Exercise 13.5. The view in frame 0 ... frames - 1 of a turntable: the camera goes once around the
// point that it looks at, about the direction `up`, counterclockwise as seen from above. Frame 0 is
// `view`. There is 1 frame or more.
// Star: frame 0 is `view` bit for bit, and so are the frames `frames`, 2 * `frames` and so on.
inline View turned_view(View view, int frame, int frames) {
    return rt::todo("13.5", view, frame, frames);
}

}  // namespace rt
