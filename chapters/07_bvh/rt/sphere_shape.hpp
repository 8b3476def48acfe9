#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/sphere_list.hpp>

namespace rt {

// The functions that a tree needs for a type of shape (given), here for spheres. The third of them,
// surface_hit, is in sphere_list.hpp. Trees and searches know nothing else about shapes, so any
// other type of shape, such as a triangle, needs these three functions, too.

// A box that contains the shape, with the margin that 07.2 adds.
inline Box bounds_of(const SceneSphere& sphere) {
    return bounds_of(sphere.shape);
}

// The smallest t within the interval at which a ray meets the shape.
inline std::optional<Real> hit_shape(const SceneSphere& sphere, const Ray& ray, Interval within) {
    return hit_sphere(sphere.shape, ray, within);
}

}  // namespace rt
