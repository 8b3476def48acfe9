#pragma once
#include <algorithm>
#include <rt/interval.hpp>
#include <rt/pack.hpp>
#include <rt/ray.hpp>
#include <rt/vec3.hpp>

namespace rt {

// The rounding errors of hit_sphere and of a box test act as if the sphere and the box were moved
// by a small distance. This constant bounds that distance, relative to the coordinates involved;
// docs/07-bvh.md derives it. If a box is grown by hit_margin * (its own largest coordinate + the
// largest of the ray's origin), every ray that hits the sphere inside the box, according to
// hit_sphere, also meets the box.
inline constexpr Real hit_margin = 80 * epsilon;

// A ray made ready for box tests (given): what all of them need is computed once.
struct SlabRay {
    Vec3 origin;
    Vec3 inverse;     // 1 / direction; infinite, with the zero's sign, if a component is 0
    Real margin = 0;  // every box counts as larger by this on all sides
};

// Makes a ray ready. The margin is only the ray's share: bounds_of(sphere) has added the box's
// share.
inline SlabRay slab_ray(const Ray& ray) {
    const Vec3 d = ray.direction;
    return {ray.origin, {1 / d.x, 1 / d.y, 1 / d.z}, hit_margin * max_component(ray.origin)};
}

// The interval in which boxes count for a search within `within`. It always contains 0: where a ray
// starts on a sphere's surface, the t of that sphere is nothing but rounding error, but the ray's
// origin, at t = 0, is certainly within the sphere's box.
constexpr Interval with_origin(Interval within) {
    return {std::min(Real(0), within.min), std::max(Real(0), within.max)};
}

}  // namespace rt
