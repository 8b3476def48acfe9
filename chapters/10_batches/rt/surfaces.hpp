#pragma once
#include <rt/arrival.hpp>
#include <rt/dielectric.hpp>
#include <rt/lambertian.hpp>
#include <rt/material_set.hpp>
#include <rt/metal.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/scene_sphere.hpp>
#include <rt/textures.hpp>
#include <rt/wide_tree.hpp>
#include <tuple>
#include <vector>

namespace rt {

// The spheres of a scene, in the form that the materials' kernels need (given).

// The types of the materials in a MaterialList or a MaterialSet; index() tells which of them a
// material has.
template <class Materials>
struct MaterialTypes;
template <class Material>
struct MaterialTypes<MaterialList<Material>> {
    using All = std::tuple<Material>;
    static std::size_t index(const Material&) { return 0; }
    template <class>
    static const Material& get(const Material& material) {
        return material;
    }
};
template <class... Types>
struct MaterialTypes<MaterialSet<Types...>> {
    using All = std::tuple<Types...>;
    static std::size_t index(const std::variant<Types...>& material) { return material.index(); }
    template <class Material>
    static const Material& get(const std::variant<Types...>& material) {
        return std::get<Material>(material);
    }
};

// Writes the data of a material into a Surface.
template <class Material>
void describe(Surface& surface, const Material& material) {
    if constexpr (requires { material.albedo; }) surface.color = material.albedo;
    if constexpr (std::is_same_v<Material, Metal>) surface.parameter = material.fuzz;
    if constexpr (std::is_same_v<Material, Dielectric>) {
        surface.color = {1, 1, 1};
        surface.parameter = material.index;
    }
}

// The spheres of a world's tree, in the order of their numbers.
template <class Materials>
struct Surfaces {
    using Types = MaterialTypes<Materials>;
    static constexpr std::size_t sky = std::tuple_size_v<typename Types::All>;
    static_assert(sky < 8, "a kind is a bit of a byte");
    std::vector<Surface> all;
    // Bit k for kind k. [0]: the sky, for no sphere; [i + 1]: the type of sphere i's material.
    std::vector<std::uint8_t> kinds;
    std::vector<std::int32_t> materials;  // each sphere's, as in SceneSphere

    Surfaces(const WideTree& tree, const Materials& set) {
        kinds.resize(tree.places.size() + 1, std::uint8_t{1} << sky);
        for (std::size_t number = 0; number < tree.places.size(); ++number) {
            const SceneSphere sphere = tree.shape(static_cast<std::int32_t>(number));
            all.push_back({sphere.shape.center, sphere.shape.radius, 0, {}});
            materials.push_back(sphere.material);
            set_material(number, set);
        }
    }

  private:
    void set_material(std::size_t number, const Materials& set) {
        const auto& element = set.materials[static_cast<std::size_t>(materials[number])];
        kinds[number + 1] = static_cast<std::uint8_t>(1u << Types::index(element));
        if constexpr (std::tuple_size_v<typename Types::All> == 1)
            describe(all[number], element);
        else
            std::visit([&](const auto& one) { describe(all[number], one); }, element);
    }
};

}  // namespace rt
