#pragma once
#include <cstddef>
#include <optional>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/scatter.hpp>
#include <vector>

namespace rt {

// A matte material: it looks equally bright from every direction.
struct Lambertian {
    Color albedo;  // the share of light that comes back, each channel in [0, 1]
};

// How a matte surface scatters light: to the side that the ray came from, in a random direction of
// length 1 with probability density cos / pi about the normal on that side. The density already
// includes the cosine of Lambert's law, so the attenuation is the albedo alone.
template <class Random>
std::optional<Scatter> scatter(const Lambertian& material, [[maybe_unused]] Vec3 incoming,
                               const Hit& hit, Random& random) {
    return Scatter{material.albedo, cosine_direction(facing_normal(hit), random_place(random))};
}

// The materials of a scene, all of one type (given). The compiler finds scatter() by this type.
template <class Material>
struct MaterialList {
    std::vector<Material> materials;

    template <class Random>
    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Random& random) const {
        return scatter(materials[static_cast<std::size_t>(hit.material)], incoming, hit, random);
    }
};

}  // namespace rt
