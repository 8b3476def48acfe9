#pragma once
#include <optional>
#include <rt/bounds.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/sphere_list.hpp>

namespace rt {

// What a tree asks of a shape (given), here for a sphere of a scene. Trees and searches know
// nothing else about shapes. Another type of shape, such as a triangle, needs these functions, too,
// and surface_hit, which spheres have from sphere_list.hpp.

// A box that contains the shape, with the margin that 07.2 adds.
inline Box bounds_of(const SceneSphere& sphere) {
    return bounds_of(sphere.shape);
}

// The smallest t within the interval at which a ray meets the shape.
inline std::optional<Real> hit_shape(const SceneSphere& sphere, const Ray& ray, Interval within) {
    return hit_sphere(sphere.shape, ray, within);
}

}  // namespace rt
