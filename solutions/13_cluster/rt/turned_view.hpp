#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/view.hpp>

namespace rt {

// The view in one frame of a turntable; `frame` goes from 0 to frames - 1. The camera goes once
// around the point that it looks at, about the direction `up`, counterclockwise as seen from above.
// Frame 0 is `view` bit for bit, and so is every frame whose number is a multiple of `frames`.
// `frames` is 1 or more.
inline View turned_view(View view, int frame, int frames) {
    if (frame % frames == 0) return view;
    const Vec3 axis = normalize(view.up), away = view.from - view.at;
    const Vec3 along = dot(away, axis) * axis, across = away - along;
    const Real angle = 2 * pi * static_cast<Real>(frame % frames) / static_cast<Real>(frames);
    view.from = view.at + along + portable::cos(angle) * across +
                portable::sin(angle) * cross(axis, across);
    return view;
}

}  // namespace rt
