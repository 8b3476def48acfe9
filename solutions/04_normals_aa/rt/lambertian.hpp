#pragma once
#include <cstddef>
#include <optional>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/scatter.hpp>
#include <vector>

namespace rt {

// A matte material (given): it looks equally bright from everywhere. Light comes back in random
// directions; since those are chosen as likely as the cosine of Lambert's law, the attenuation is
// the albedo alone.
struct Lambertian {
    Color albedo;  // the share of light that comes back, each channel in [0, 1]
};

template <class Random>
std::optional<Scatter> scatter(const Lambertian& material, Vec3 /*incoming*/, const Hit& hit,
                               Random& random) {
    return Scatter{material.albedo, cosine_direction(facing_normal(hit), random_place(random))};
}

// The materials of a scene, all of one type (given). scatter() is found by the material's type.
template <class Material>
struct MaterialList {
    std::vector<Material> materials;

    template <class Random>
    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Random& random) const {
        return scatter(materials[static_cast<std::size_t>(hit.material)], incoming, hit, random);
    }
};

}  // namespace rt
