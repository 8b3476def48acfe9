#pragma once
#include <rt/cross.hpp>
#include <rt/dot.hpp>
#include <rt/length.hpp>
#include <rt/portable.hpp>
#include <rt/view.hpp>

namespace rt {

inline View turned_view(View view, int frame, int frames) {
    const Vec3 axis = normalize(view.up), away = view.from - view.at;
    const Vec3 along = dot(away, axis) * axis, across = away - along;
    const Real angle = 2 * pi * static_cast<Real>(frame) / static_cast<Real>(frames);
    view.from = view.at + along + portable::cos(angle) * across +
                portable::sin(angle) * cross(axis, across);
    return view;
}

}  // namespace rt
