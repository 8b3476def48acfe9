#pragma once
#include <rt/arrival.hpp>
#include <rt/dielectric.hpp>
#include <rt/matte_pack.hpp>
#include <rt/metal.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/sine_cosine.hpp>
#include <rt/textures.hpp>

namespace rt {

// The materials' scatter(), for packs of paths that arrive at the same kind of material (given).
// Returns the direction in which each path goes on. The first argument only tells the kind of
// material; random(i) is the generator of path i. The arithmetic of chapters 04 and 05 is written
// again here, because rays of one pack may take different sides of an `if`.

// All matte materials, whatever their color.
template <class Matte, class RandomOf>
Vec3Pack scatter_pack(const Matte*, const Arrivals& at, const RandomOf& random,
                      const PathPack& pack) {
    return cosine_direction(at.facing_normal, random_places(pack.size, random), pack.active);
}

template <class RandomOf>
Vec3Pack scatter_pack(const Mirror*, const Arrivals& at, const RandomOf&, const PathPack& pack) {
    return above_horizon(reflect(at.direction, at.facing_normal), at.facing_normal, pack.active);
}

template <class RandomOf>
Vec3Pack scatter_pack(const Metal*, const Arrivals& at, const RandomOf& random,
                      const PathPack& pack) {
    const PlacePack place = random_places(pack.size, random);
    const Pack z = 1 - 2 * place.x, radius = 2 * sqrt(place.x * (1 - place.x));
    const auto [sine, cosine] = sine_cosine_of_turn(place.y);
    const Vec3Pack uniform{radius * cosine, radius * sine, z};
    const Vec3Pack mirrored = reflect(at.direction, at.facing_normal);
    return above_horizon(mirrored + at.parameter * uniform, at.facing_normal, pack.active);
}

// fresnel_reflectance of 05.4.
inline Pack fresnel_reflectance(Pack cosine, Pack eta) {
    const Pack c = min(cosine, pack_of(1)), scaled = eta * c;
    const Pack product = (eta - 1) * (eta + 1);
    const Pack error = fma(eta - 1, eta + 1, -product);
    const Pack squared = fma(scaled, scaled, -product) - error;
    const Pack beyond = sqrt(squared), sum = eta * c + beyond;
    const Pack r_s = product / (sum * sum);
    const Pack cosines = c * beyond, sines = eta * (1 - c) * (1 + c);
    const Pack p_over_s = (cosines - sines) / (cosines + sines);
    const Pack partly = min(pack_of(1), r_s * r_s * (1 + p_over_s * p_over_s) / 2);
    return eta == 1 ? Pack{} : (squared < 0 ? pack_of(1) : partly);
}

// refract of 05.3; `goes` tells which of the paths are refracted. For paths close to the critical
// angle, which are rare, the function for a single path is called.
inline Vec3Pack refract(Vec3Pack incoming, Vec3Pack normal, Pack eta, PackBits active,
                        PackMask& goes) {
    const Pack cosine = -dot(incoming, normal);
    const Vec3Pack along = eta * (incoming + cosine * normal);
    const Pack squared = 1 - dot(along, along);
    const PackMask same = eta == 1;
    const PackMask close = (abs(squared) <= rounding_bound(8) * (1 + eta)) & ~same;
    goes = same | (squared >= 0);
    Vec3Pack refracted = pick(same, incoming, along - sqrt(squared) * normal);
    for_each_bit(bits_of(close) & active, [&](std::size_t i) {
        const auto one = refract(get(incoming, i), get(normal, i), eta[i]);
        goes[i] = one ? -1 : 0;
        if (one) set(refracted, i, *one);
    });
    return refracted;
}

template <class RandomOf>
Vec3Pack scatter_pack(const Dielectric*, const Arrivals& at, const RandomOf& random,
                      const PathPack& pack) {
    const Pack eta = at.front ? 1 / at.parameter : at.parameter;
    const Pack reflected = fresnel_reflectance(-dot(at.direction, at.facing_normal), eta);
    Pack drawn = pack_of(1);
    for_each_bit(bits_of(reflected > 0) & pack.active,
                 [&](std::size_t i) { drawn[i] = random(i).uniform(); });
    PackMask can_go;
    const Vec3Pack through = refract(at.direction, at.facing_normal, eta, pack.active, can_go);
    const PackMask goes = can_go & ~(drawn < reflected);
    const PackBits stays = pack.active & ~bits_of(goes);
    if (stays == 0) return through;
    const Vec3Pack mirrored = reflect(at.direction, at.facing_normal);
    return pick(goes, through, above_horizon(mirrored, at.facing_normal, stays));
}

}  // namespace rt
