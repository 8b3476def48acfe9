#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/shape_tree.hpp>
#include <rt/timed_ray.hpp>

namespace rt {

// A sphere that moves along a line while the shutter is open (given).
struct MovingSphere {
    Sphere shape;  // at time 0
    Vec3 motion;   // how far it has moved from there at time 1
    int material = 0;
};

// The sphere at a time in [0, 1].
inline Sphere sphere_at(const MovingSphere& sphere, Real time) {
    return moved(sphere.shape, time * sphere.motion);
}

// A box that the sphere never leaves.
inline Box bounds_of(const MovingSphere& sphere) {
    const Sphere end = sphere_at(sphere, 1);
    // Every position in between is rounded twice. The spheres at both ends are made larger by that
    // error, so that the box around them contains all positions.
    const Real larger =
        rounding_bound(4) * std::max(max_component(sphere.shape.center), max_component(end.center));
    return join(bounds_of(Sphere{sphere.shape.center, sphere.shape.radius + larger}),
                bounds_of(Sphere{end.center, end.radius + larger}));
}

// A ray meets the sphere at the position that the sphere has at the ray's time.
inline std::optional<Real> hit_shape(const MovingSphere& sphere, const TimedRay& ray,
                                     Interval within) {
    return hit_sphere(sphere_at(sphere, ray.time), ray, within);
}
inline Hit surface_hit(const MovingSphere& sphere, const TimedRay& ray, Real t) {
    return surface_hit(SceneSphere{sphere_at(sphere, ray.time), sphere.material}, ray, t);
}

}  // namespace rt
