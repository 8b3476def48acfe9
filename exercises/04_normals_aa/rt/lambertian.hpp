#pragma once
#include <cstddef>
#include <optional>
#include <rt/directions.hpp>
#include <rt/hit.hpp>
#include <rt/scatter.hpp>
#include <rt/todo.hpp>
#include <vector>

namespace rt {

// A matte material: it looks equally bright from everywhere.
struct Lambertian {
    Color albedo;  // the share of light that comes back, each channel in [0, 1]
};

// Exercise 04.4. How light comes back from a matte surface, wherever it came from: on the side
// that the ray came from, in a random direction, drawn from `random` with probability density
// cos / pi about the normal there. The attenuation is the albedo alone: the density already
// includes the cosine of Lambert's law. Nothing is absorbed: there is always a Scatter.
// Star: the direction has length 1 within 2 epsilon, and its cosine with the normal on that side is
// greater than 0, whatever is drawn.
template <class Random>
std::optional<Scatter> scatter(const Lambertian& material, [[maybe_unused]] Vec3 incoming,
                               const Hit& hit, Random& random) {
    return rt::todo("04.4", material, incoming, hit, random);
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
