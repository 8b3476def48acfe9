#pragma once
#include <rt/mesh_materials.hpp>
#include <rt/rough_metal.hpp>
#include <rt/scene.hpp>
#include <utility>
#include <vector>

namespace rt {

// The materials of a scene, among them rough metals (given). Others is the type of all others.
template <class Others>
struct RoughMaterials {
    Others others;
    std::vector<RoughMetal> metals;
    std::vector<int> metal_of;            // for each material of the scene; -1: another material
    const SceneMeshes* meshes = nullptr;  // whose triangles may be of metal

    // The rough metal of a hit; null if it is another material.
    const RoughMetal* metal(const Hit& hit) const {
        const auto number = static_cast<std::size_t>(hit.material);
        if (number >= metal_of.size() || metal_of[number] < 0) return nullptr;
        return &metals[static_cast<std::size_t>(metal_of[number])];
    }

    // The hit with the normal of the curved surface that a triangle stands for.
    Hit smooth(Vec3 incoming, const Hit& hit) const {
        if (!meshes || !is_triangle(hit)) return hit;
        Hit smooth = hit;
        smooth.normal =
            bent_normal(MeshPoint{*meshes, hit}.normal(hit.normal), hit.normal, incoming);
        return smooth;
    }

    template <class Random>
    std::optional<Scatter> operator()(Vec3 incoming, const Hit& hit, Random& random) const {
        const RoughMetal* const rough = metal(hit);
        if (!rough) return others(incoming, hit, random);
        std::optional<Scatter> bounce = scatter(*rough, incoming, smooth(incoming, hit), random);
        // Below the flat triangle there is nothing to see.
        if (bounce && !(dot(bounce->direction, facing_normal(hit)) > 0))
            bounce = Scatter{{}, facing_normal(hit)};
        return bounce;
    }
};

template <class Others>
Real scatter_density(const RoughMaterials<Others>& set, const Hit& hit, Vec3 direction) {
    return set.metal(hit) ? Real(0) : scatter_density(set.others, hit, direction);
}
template <class Others>
Real scatter_density(const RoughMaterials<Others>& set, Vec3 incoming, const Hit& hit,
                     Vec3 direction) {
    const RoughMetal* const rough = set.metal(hit);
    if (!rough) return scatter_density(set.others, incoming, hit, direction);
    if (!(dot(direction, facing_normal(hit)) > 0)) return 0;
    return scatter_density(*rough, incoming, set.smooth(incoming, hit), direction);
}
template <class Others>
Vec3 leaving_point(const RoughMaterials<Others>& set, const Hit& hit, Vec3 direction) {
    return leaving_point(set.others, hit, direction);
}
template <class Others>
bool came_through_glass(const RoughMaterials<Others>& set, const Hit& hit) {
    return came_through_glass(set.others, hit);
}

// What of the light from a direction goes on along the path, divided by the density of the
// direction. For most materials it is the same for all directions, as that of the bounce.
template <class Materials>
Color attenuation_from(const Materials& /*materials*/, Vec3 /*incoming*/, const Hit& /*hit*/,
                       Vec3 /*direction*/, Color of_bounce) {
    return of_bounce;
}
template <class Others>
Color attenuation_from(const RoughMaterials<Others>& set, Vec3 incoming, const Hit& hit,
                       Vec3 direction, Color of_bounce) {
    const RoughMetal* const rough = set.metal(hit);
    if (!rough) return of_bounce;
    return RoughPoint{*rough, incoming, set.smooth(incoming, hit)}.color(direction);
}

// The rough metals of a scene, beside its other materials.
template <class Others>
RoughMaterials<Others> with_rough_metals(Others others, const SceneDescription& scene,
                                         const SceneMeshes* meshes) {
    RoughMaterials<Others> set{std::move(others), {}, {}, meshes};
    for (const MaterialDescription& material : scene.materials) {
        const auto* const rough = std::get_if<RoughDescription>(&material);
        set.metal_of.push_back(rough ? static_cast<int>(set.metals.size()) : -1);
        if (rough) set.metals.push_back(make_rough_metal(rough->albedo, rough->roughness));
    }
    return set;
}

}  // namespace rt
