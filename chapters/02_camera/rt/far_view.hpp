#pragma once
#include <rt/portable.hpp>
#include <rt/vec3.hpp>
#include <rt/view.hpp>

namespace study {

// The same view from `times` the distance, with a field of view so narrow that the picture shows
// the same part of the scene. Only the rounding errors change: they grow with the distance.
inline rt::View from_afar(rt::View view, rt::Real times) {
    view.from = view.at + times * (view.from - view.at);
    view.vertical_fov = 2 * rt::portable::atan(rt::portable::tan(view.vertical_fov / 2) / times);
    return view;
}

}  // namespace study
