#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define primary_ray primary_ray_unfollowed
#include_next <rt/primary_ray.hpp>
#undef primary_ray
#include <rt/trail.hpp>

namespace rt {

inline Ray primary_ray(const Camera& camera, int column, int row, Vec2 offset) {
    const Ray ray = primary_ray_unfollowed(camera, column, row, offset);
    follow::note_camera_ray(camera, offset, ray);
    return ray;
}

}  // namespace rt
