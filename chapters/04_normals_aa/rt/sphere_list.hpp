#pragma once
#include <optional>
#include <rt/hit.hpp>
#include <rt/interval.hpp>
#include <rt/nearest_sphere.hpp>
#include <rt/surface_hit.hpp>
#include <vector>

namespace rt {

// Where a ray meets a sphere of a scene at t.
inline Hit surface_hit(const SceneSphere& sphere, const Ray& ray, Real t) {
    Hit hit = surface_hit(sphere.shape, ray, t);
    hit.material = sphere.material;
    hit.light = sphere.light;
    return hit;
}

// A world of spheres (given): each ray is tested against all of them.
struct SphereList {
    std::vector<SceneSphere> spheres;

    // The nearest hit within the interval. The ray may be of any type with origin and direction.
    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray ray{any_ray.origin, any_ray.direction};
        const auto nearest = nearest_sphere(spheres, ray, within);
        if (!nearest) return {};
        Hit hit = surface_hit(spheres[nearest->number], ray, nearest->t);
        hit.shape = static_cast<int>(nearest->number);
        return hit;
    }
};

}  // namespace rt
