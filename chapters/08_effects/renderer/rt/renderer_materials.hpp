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

// Two lists of types in one.
template <class... Types>
struct TypeList {};
template <class... First, class... Second>
TypeList<First..., Second...> operator+(TypeList<First...>, TypeList<Second...>);

// The types of material in a renderer with these effects (given). A new material gets a line here.
// Metal without fuzz is a Mirror, which draws no random numbers, and a material with an image is an
// ImageMatte.
template <Effects effects>
struct RendererMaterials {
    template <bool present, class... Types>
    using If = std::conditional_t<present, TypeList<Types...>, TypeList<>>;

    // A single type needs no lookup.
    template <class Only>
    static MaterialList<Only> container(TypeList<Only>);
    template <class... Types>
    static MaterialSet<Types...> container(TypeList<Types...>);

    using Type = decltype(container(TypeList<Lambertian>{} +           //
                                    If<effects.mirror, Mirror>{} +     //
                                    If<effects.fuzz, Metal>{} +        //
                                    If<effects.glass, Dielectric>{} +  //
                                    If<effects.texture, CheckeredMatte, ImageMatte>{} +
                                    If<effects.own, OwnMaterial>{}));
};

// Any of these materials.
using ReadyMaterial = decltype(RendererMaterials<every_effect>::Type::materials)::value_type;

}  // namespace rt
