#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <rt/directions.hpp>
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/orthonormal_basis.hpp>
#include <rt/portable.hpp>
#include <rt/reflect.hpp>
#include <rt/scatter.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/vec2.hpp>

namespace rt {

// A metal that spreads what it mirrors (given): its directions crowd around the mirror direction,
// with a density in proportion to e^(k cos a), where a is the angle to it and k the concentration.
// On average, they are about 1 / sqrt(k) radians away from it along each axis.
// Source: the distribution of von Mises and Fisher; Fisher, "Dispersion on a sphere", 1953.
struct Lobe {
    Color albedo;
    Real concentration = 1;  // greater than 0
};

// The density of a direction, per solid angle. 1 - cos a is half the squared distance of the two
// directions, whose digits do not cancel.
inline Real lobe_density_around(Vec3 mirrored, Real concentration, Vec3 direction) {
    const Vec3 apart = direction - mirrored;
    const Real below_1 = dot(apart, apart) / 2;
    const Real whole = 2 * pi * (1 - portable::exp(-2 * concentration));
    return concentration / whole * portable::exp(-concentration * below_1);
}

// Directions below the surface are mirrored at it, so no light is lost.
template <class Random>
std::optional<Scatter> scatter(const Lobe& lobe, Vec3 incoming, const Hit& hit, Random& random) {
    const Vec3 normal = facing_normal(hit);
    const Vec2 place = random_place(random);
    const Real k = lobe.concentration;
    // The inverse of the cumulative distribution of 1 - cos a.
    const Real below_1 =
        std::min(Real(2), -std::numbers::ln2_v<Real> *
                              portable::log2(1 - place.x * (1 - portable::exp(-2 * k))) / k);
    const Real sine = std::sqrt(below_1 * (2 - below_1));
    const auto turn = sine_cosine_of_turn(place.y);
    const Vec3 direction =
        normalize(orthonormal_basis(reflect(incoming, normal))
                      .to_world({sine * turn.cosine, sine * turn.sine, 1 - below_1}));
    return Scatter{lobe.albedo,
                   dot(direction, normal) < 0 ? reflect(direction, normal) : direction};
}

// As in fuzz_density.hpp: the density of the direction itself, and of the one below the surface
// that is mirrored to it.
inline Real scatter_density(const Lobe& lobe, Vec3 incoming, const Hit& hit, Vec3 direction) {
    const Vec3 normal = facing_normal(hit);
    if (!(dot(normal, direction) > 0)) return 0;
    const Vec3 mirrored = reflect(incoming, normal);
    return lobe_density_around(mirrored, lobe.concentration, direction) +
           lobe_density_around(mirrored, lobe.concentration, reflect(direction, normal));
}
inline Real scatter_density(const Lobe&, const Hit&, Vec3) {
    return 0;  // without `incoming`, the mirror direction is unknown
}

}  // namespace rt
