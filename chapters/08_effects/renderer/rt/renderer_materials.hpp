#pragma once
#include <rt/dielectric.hpp>
#include <rt/effects.hpp>
#include <rt/lambertian.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/own_material.hpp>
#include <rt/textures.hpp>
#include <type_traits>

namespace rt {

// The types of material that renderers use (given): metal without fuzz is a Mirror, which draws no
// random numbers, and a material with an image is an ImageMatte. A chapter that adds a material
// adds its type here. The renderers that have every effect have all of these types.
using AllMaterials =
    MaterialSet<Lambertian, Mirror, Metal, Dielectric, CheckeredMatte, ImageMatte, OwnMaterial>;
using ReadyMaterial = decltype(AllMaterials::materials)::value_type;

// The effects whose materials are found only in renderers that have every effect.
inline constexpr Effects rare_materials{.own = true};

// The materials of a renderer with these effects.
template <Effects effects>
struct RendererMaterials {
    template <bool condition, class Yes, class No>
    using Either = std::conditional_t<condition, Yes, No>;

    static constexpr bool metal = effects.mirror || effects.fuzz;
    static constexpr bool one_material = !metal && !effects.glass && !effects.texture;
    static constexpr bool all = without(effects, rare_materials) != effects;
    using Type = Either<
        all, AllMaterials,
        Either<one_material, MaterialList<Lambertian>,
               Either<!effects.glass && !effects.texture, MaterialSet<Lambertian, Mirror, Metal>,
                      Either<!metal && !effects.texture, MaterialSet<Lambertian, Dielectric>,
                             MaterialSet<Lambertian, Mirror, Metal, Dielectric, CheckeredMatte,
                                         ImageMatte>>>>>;
};

}  // namespace rt
