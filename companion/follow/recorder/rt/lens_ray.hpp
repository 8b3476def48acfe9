#pragma once
#pragma GCC system_header  // #include_next is no part of the standard
#define lens_ray lens_ray_unfollowed
#include_next <rt/lens_ray.hpp>
#undef lens_ray
#include <rt/trail.hpp>
#include <utility>

namespace rt {

inline Ray lens_ray(const Camera& camera, const Lens& lens, int column, int row, Vec2 offset,
                    Vec2 place) {
    const follow::Place before = std::exchange(follow::here, {});  // it may call primary_ray
    const Ray ray = lens_ray_unfollowed(camera, lens, column, row, offset, place);
    follow::here = before;
    follow::note_camera_ray(camera, offset, ray);
    return ray;
}

}  // namespace rt
