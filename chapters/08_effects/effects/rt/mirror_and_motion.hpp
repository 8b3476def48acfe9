#pragma once
#include <optional>
#include <rt/above_horizon.hpp>
#include <rt/bounds.hpp>
#include <rt/hit.hpp>
#include <rt/ray.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>
#include <rt/shape_tree.hpp>

// A material and a shape that need no exercise: all that a mirror and a moving sphere add to matte
// spheres that stand still. Others are added in the same way.

namespace rt {

// Metal without fuzz (given). Nothing about it is random, so no random numbers are drawn for it.
struct Mirror {
    Color albedo;  // the share of light that comes back, each channel in [0, 1]
};

template <class Random>
std::optional<Scatter> scatter(const Mirror& material, Vec3 incoming, const Hit& hit,
                               Random& /*random*/) {
    const Vec3 normal = facing_normal(hit);
    return Scatter{material.albedo, above_horizon(reflect(incoming, normal), normal)};
}

// A ray with a time (given): 0 as the shutter opens, 1 as it closes. The path loop passes the time
// on from bounce to bounce without knowing about it. Code that does not need the time uses the
// TimedRay as a plain Ray.
struct TimedRay {
    Vec3 origin, direction;
    Real time = 0;

    operator Ray() const { return {origin, direction}; }
};

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
