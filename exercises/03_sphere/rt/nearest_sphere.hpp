#pragma once
#include <optional>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/nearest.hpp>
#include <rt/ray.hpp>
#include <rt/scene_sphere.hpp>
#include <rt/todo.hpp>
#include <span>

namespace rt {

// Exercise 03.3. The sphere that the ray meets at the smallest t within the interval, and this t.
// If several spheres are equally near, the last of them in the list counts. Return {} if the ray
// meets no sphere within the interval, and for an empty list. t is exactly what hit_sphere (03.2)
// returns for this sphere alone. The spheres come in any order, and may overlap or lie within each
// other.
// Star: this holds for scenes of any size, and the last digit of t counts.
inline std::optional<NearestSphere> nearest_sphere(std::span<const SceneSphere> spheres,
                                                   const Ray& ray, Interval within) {
    return rt::todo("03.3", spheres, ray, within);
}

}  // namespace rt
