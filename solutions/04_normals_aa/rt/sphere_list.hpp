#pragma once
#include <optional>
#include <rt/hit.hpp>
#include <rt/hit_sphere.hpp>
#include <rt/interval.hpp>
#include <rt/surface_hit.hpp>
#include <vector>

namespace rt {

// A sphere of a scene, and which of the scene's materials it is made of.
struct SceneSphere {
    Sphere shape;
    int material = 0;
};

// A world of spheres (given): each ray tries them all.
struct SphereList {
    std::vector<SceneSphere> spheres;

    // The nearest hit within the interval. The ray may be of any type with origin and direction.
    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& any_ray, Interval within) const {
        const Ray ray{any_ray.origin, any_ray.direction};
        const SceneSphere* nearest = nullptr;
        for (const SceneSphere& sphere : spheres)
            if (const auto t = hit_sphere(sphere.shape, ray, within)) {
                within.max = *t;
                nearest = &sphere;
            }
        if (!nearest) return {};
        Hit hit = surface_hit(nearest->shape, ray, within.max);
        hit.material = nearest->material;
        return hit;
    }
};

}  // namespace rt
