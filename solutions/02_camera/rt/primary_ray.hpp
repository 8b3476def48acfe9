#pragma once
#include <rt/camera.hpp>
#include <rt/length.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>

namespace rt {

// The ray from the eye through a point of a pixel (see pixel_to_viewport). Its direction has length
// 1; each component has an error of at most 7 epsilon.
inline Ray primary_ray(const Camera& camera, int column, int row, Vec2 offset) {
    const Vec2 p = pixel_to_viewport(camera, column, row, offset);
    return {camera.eye, normalize(camera.basis.to_world({p.x, p.y, -1}))};
}

}  // namespace rt
