#pragma once
#include <rt/portable.hpp>
#include <rt/vec3.hpp>
#include <rt/view.hpp>

namespace study {

// The same view from so many times as far away, through a lens that shows as much: what is rounded
// grows with the distance, and the picture stays.
inline rt::View from_afar(rt::View view, rt::Real times) {
    view.from = view.at + times * (view.from - view.at);
    view.vertical_fov = 2 * rt::portable::atan(rt::portable::tan(view.vertical_fov / 2) / times);
    return view;
}

}  // namespace study
