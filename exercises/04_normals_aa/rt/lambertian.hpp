#pragma once
#include <cstddef>
#include <optional>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// A matte material: it looks equally bright from every direction.
struct Lambertian {
    Color albedo;  // the share of light that comes back, each channel in [0, 1]
};

// Exercise 04.4. How a matte surface scatters light from any direction: to the side that the ray
// came from, in a random direction, drawn from `random` with probability density cos / pi about the
// normal on that side. The attenuation is the albedo alone, because the density already includes
// the cosine of Lambert's law. Nothing is absorbed: there is always a Scatter.
// Star: the direction has length 1 within 2 epsilon, and its cosine with the normal on that side is
// greater than 0, whatever is drawn.
template <class Random>
std::optional<Scatter> scatter(const Lambertian& material, [[maybe_unused]] Vec3 incoming,
                               const Hit& hit, Random& random) {
    return rt::todo("04.4", material, incoming, hit, random);
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
