#pragma once
#include <rt/camera.hpp>
#include <rt/length.hpp>
#include <rt/pixel.hpp>
#include <rt/ray.hpp>

namespace rt {

inline Ray primary_ray(const Camera& camera, int column, int row, Vec2 offset) {
    const Vec2 p = pixel_to_viewport(camera, column, row, offset);
    return {camera.eye, camera.basis.to_world({p.x, p.y, -1})};
}

}  // namespace rt
