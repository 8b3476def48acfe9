#pragma once
#include <cstddef>
#include <optional>
#include <rt/hit.hpp>
#include <rt/scatter.hpp>
#include <variant>
#include <vector>

namespace rt {

// The materials of a scene, of these types and no others (given). Each material is a std::variant,
// which holds a value of one of these types; std::visit looks up which type that is, and calls its
// scatter(). If Dielectric is not in the list, refraction is not even compiled in.
template <class... Types>
struct MaterialSet {
    std::vector<std::variant<Types...>> materials;

    template <class Random>
    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Random& random) const {
        return std::visit(
            [&](const auto& material) { return scatter(material, incoming, hit, random); },
            materials[static_cast<std::size_t>(hit.material)]);
    }
};

}  // namespace rt
