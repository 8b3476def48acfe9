#pragma once
#include <rt/camera.hpp>
#include <rt/look_at.hpp>
#include <rt/viewport.hpp>

namespace rt {

// The camera that takes a picture of width x height pixels of this view (given, not an exercise).
// Throws std::domain_error if the view makes no sense: see viewport_size and look_at.
inline Camera make_camera(const View& view, int width, int height) {
    const Real aspect_ratio = static_cast<Real>(width) / static_cast<Real>(height);
    return {view.from, look_at(view.from, view.at, view.up),
            viewport_size(view.vertical_fov, aspect_ratio), width, height};
}

}  // namespace rt
