#pragma once
#include <cmath>
#include <rt/dot.hpp>
#include <rt/hit.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/reflect.hpp>
#include <rt/spread.hpp>

namespace rt {

// The probability density, per solid angle, of the direction of mirrored + fuzz * u, where u is a
// random point of the unit sphere (all points equally likely) and 0 < fuzz <= 1 (given). The ray
// along `direction` cuts the sphere of these points at the distances c - s and c + s, where c is
// the cosine of the angle to the mirror direction and s^2 = c^2 - 1 + fuzz^2. A piece of the sphere
// at the distance t is seen as the solid angle (its area) (s / fuzz) / t^2. Both cuts together make
//
//     ((c - s)^2 + (c + s)^2) / (4 pi fuzz^2) / (s / fuzz) = (c^2 + s^2) / (2 pi fuzz s).
//
// The density is 0 outside of the cone in which the sphere is seen, and, if fuzz < 1, grows without
// limit at its rim.
inline Real lobe_density(Vec3 mirrored, Real fuzz, Vec3 direction) {
    const Real cosine = dot(mirrored, direction);
    if (!(cosine > 0)) return 0;
    const Real squared = cosine * cosine - 1 + fuzz * fuzz;
    // Both directions have length 1 within a few epsilon, so `squared` is off by up to this. A
    // direction at the rim counts as one just inside: its density is finite, and is not 0.
    const Real error = rounding_bound(16);
    if (squared < -error) return 0;
    const Real inside = std::max(squared, error);
    return (cosine * cosine + inside) / (2 * pi * fuzz * std::sqrt(inside));
}

// Metal smoother than this reflects into so narrow a cone that samples of lights mostly miss it. In
// measurements on balls with small lamps, samples reduced the error of the displayed picture only
// if the fuzz was at least this.
inline constexpr Real least_sampled_fuzz = Real(0.2);

// Like scatter_density in spread.hpp, but for rough metal it gives the density, too (given): that
// of the direction itself, plus that of the direction below the surface that is folded up to it.
// For smoother metal the density is 0: only the path itself finds lights there, as in a mirror.
// `incoming` is the direction of the ray that made the hit.
template <class Material>
Real scatter_density(const Material& material, Vec3 /*incoming*/, const Hit& hit, Vec3 direction) {
    return scatter_density(material, hit, direction);
}
inline Real scatter_density(const Metal& metal, Vec3 incoming, const Hit& hit, Vec3 direction) {
    const Vec3 normal = facing_normal(hit);
    if (metal.fuzz < least_sampled_fuzz || !(dot(normal, direction) > 0)) return 0;
    const Vec3 mirrored = reflect(incoming, normal);
    return lobe_density(mirrored, metal.fuzz, direction) +
           lobe_density(mirrored, metal.fuzz, reflect(direction, normal));
}
template <class... Types>
Real scatter_density(const MaterialSet<Types...>& set, Vec3 incoming, const Hit& hit,
                     Vec3 direction) {
    return std::visit(
        [&](const auto& material) { return scatter_density(material, incoming, hit, direction); },
        set.materials[static_cast<std::size_t>(hit.material)]);
}

}  // namespace rt
