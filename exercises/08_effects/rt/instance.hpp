#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/placed_sphere.hpp>
#include <rt/surface_hit.hpp>
#include <rt/todo.hpp>

namespace rt {

// Exercise 08.5. The ray in the object's space, where the instance is the unit sphere around (0, 0,
// 0). Transform the ray's origin as a point and its direction as a vector. Do not normalize the
// direction: then t has the same value for the object's ray and for the world's ray.
inline Ray object_ray(const Instance& instance, const Ray& ray) {
    return rt::todo("08.5", instance, ray);
}

// Exercise 08.5. The smallest t within the interval at which the world's ray meets the instance,
// from outside or from inside; none if it misses.
inline std::optional<Real> hit_instance(const Instance& instance, const Ray& ray, Interval within) {
    return rt::todo("08.5", instance, ray, within);
}

// Exercise 08.5. Everything about the point where a ray meets an instance. The ray and the result
// are in the world's coordinates; t is what hit_instance returned. The point lies on the surface.
// The normal has length 1, points outward, and is right for stretched spheres, too. front is true
// if the ray came from outside, point_error is instance_error for this point, and material is the
// instance's.
// Star: this holds for any map. A ray that leaves the surface does not meet it again.
inline Hit surface_hit(const Instance& instance, const Ray& ray, Real t) {
    return rt::todo("08.5", instance, ray, t);
}

// Exercise 08.5. The smallest box around an instance, grown on all sides by
//     margin_factor(instance) * hit_margin * (m + r),
// where m is the largest absolute coordinate of the box's center, and r the largest of the three
// distances from the center to a face.
// Star: this holds for any map.
inline Box bounds_of(const Instance& instance) {
    return rt::todo("08.5", instance);
}

}  // namespace rt
