#pragma once
#include <cstddef>
#include <rt/hit.hpp>
#include <rt/lambert.hpp>
#include <rt/lambertian.hpp>
#include <rt/material_set.hpp>
#include <type_traits>

namespace rt {

// Only their names are needed here, so that files that include this one compile faster.
struct CheckeredMatte;
struct ImageMatte;
struct Mirror;
struct Metal;
struct Dielectric;
struct OwnMaterial;

// The probability density, per solid angle, with which scatter() of a material takes a direction
// (given). It is 0 for materials for which light cannot be sampled: mirrors and glass allow single
// directions only, reflections of lights in rough metal are found by the path itself (or with
// fuzz_density.hpp), and the density of a material that you invent is unknown.
inline Real cosine_density(const Hit& hit, Vec3 direction) {
    return lambert(facing_normal(hit), direction) / pi;
}
inline Real scatter_density(const Lambertian&, const Hit& hit, Vec3 direction) {
    return cosine_density(hit, direction);
}
inline Real scatter_density(const CheckeredMatte&, const Hit& hit, Vec3 direction) {
    return cosine_density(hit, direction);
}
inline Real scatter_density(const ImageMatte&, const Hit& hit, Vec3 direction) {
    return cosine_density(hit, direction);
}
inline Real scatter_density(const Mirror&, const Hit&, Vec3) {
    return 0;
}
inline Real scatter_density(const Metal&, const Hit&, Vec3) {
    return 0;
}
inline Real scatter_density(const Dielectric&, const Hit&, Vec3) {
    return 0;
}
inline Real scatter_density(const OwnMaterial&, const Hit&, Vec3) {
    return 0;
}

// The same for whichever of the scene's materials was hit.
template <class Material>
Real scatter_density(const MaterialList<Material>& set, const Hit& hit, Vec3 direction) {
    return scatter_density(set.materials[static_cast<std::size_t>(hit.material)], hit, direction);
}
template <class... Types>
Real scatter_density(const MaterialSet<Types...>& set, const Hit& hit, Vec3 direction) {
    return std::visit(
        [&](const auto& material) { return scatter_density(material, hit, direction); },
        set.materials[static_cast<std::size_t>(hit.material)]);
}

// True when the ray that made this hit met glass from within, where there is no fog.
template <class Material>
bool came_through_glass(const MaterialList<Material>&, const Hit& hit) {
    return !hit.front && std::is_same_v<Material, Dielectric>;
}
template <class... Types>
bool came_through_glass(const MaterialSet<Types...>& set, const Hit& hit) {
    if constexpr ((std::is_same_v<Types, Dielectric> || ...)) {
        return !hit.front && std::holds_alternative<Dielectric>(
                                 set.materials[static_cast<std::size_t>(hit.material)]);
    } else {
        return false;
    }
}

}  // namespace rt
