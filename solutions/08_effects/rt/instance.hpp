#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/placed_sphere.hpp>
#include <rt/surface_hit.hpp>

namespace rt {

// The ray in the object's own coordinates. The direction is not normalized, so the object's t is
// the world's t.
inline Ray object_ray(const Instance& instance, const Ray& ray) {
    return {transform_point(instance.world_to_object, ray.origin),
            transform_vector(instance.world_to_object, ray.direction)};
}

// The smallest t within the interval at which the ray meets the instance.
inline std::optional<Real> hit_instance(const Instance& instance, const Ray& ray, Interval within) {
    return hit_sphere(unit_sphere, object_ray(instance, ray), within);
}

// Everything about the point where a ray meets an instance at t, in the world's coordinates.
inline Hit surface_hit(const Instance& instance, const Ray& ray, Real t) {
    Hit hit = surface_hit(unit_sphere, object_ray(instance, ray), t);
    hit.point = transform_point(instance.object_to_world, hit.point);
    hit.normal = normalize(transform_normal(instance.world_to_object, hit.normal));
    hit.front = dot(ray.direction, hit.normal) <= 0;
    hit.point_error = instance_error(instance, hit.point);
    hit.material = instance.material;
    return hit;
}

// The box around an instance, grown by margin_factor times hit_margin times the largest coordinate
// in it. Along x, the half width of the box is the length of the matrix's first row: the largest x
// that the matrix gives to a point of the unit sphere, minus the x of the box's center.
inline Box bounds_of(const Instance& instance) {
    const Mat4& m = instance.object_to_world;
    const auto reach = [&](int row) { return length(Vec3{m(row, 0), m(row, 1), m(row, 2)}); };
    const Vec3 center{m(0, 3), m(1, 3), m(2, 3)}, half{reach(0), reach(1), reach(2)};
    const Real margin =
        margin_factor(instance) * hit_margin * (max_component(center) + max_component(half));
    const Vec3 grown = half + Vec3{margin, margin, margin};
    return {center - grown, center + grown};
}

}  // namespace rt
