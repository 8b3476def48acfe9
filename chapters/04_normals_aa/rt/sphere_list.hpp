#pragma once
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/surface_hit.hpp>
#include <vector>

namespace rt {

// A world of spheres (given): each ray tries them all.
struct SphereList {
    std::vector<SceneSphere> spheres;

    // The nearest hit within the interval. The ray may be of any type with origin and direction.
    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray ray{any_ray.origin, any_ray.direction};
        const auto nearest = nearest_sphere(spheres, ray, within);
        if (!nearest) return {};
        const SceneSphere& sphere = spheres[nearest->number];
        Hit hit = surface_hit(sphere.shape, ray, nearest->t);
        hit.material = sphere.material;
        return hit;
    }
};

}  // namespace rt
