#pragma once
#include <rt/lambertian.hpp>
#include <rt/lights.hpp>
#include <rt/material_set.hpp>
#include <rt/mirror.hpp>
#include <rt/moving_spheres.hpp>
#include <rt/placed_sphere.hpp>
#include <rt/scene.hpp>
#include <rt/sphere_list.hpp>
#include <type_traits>
#include <variant>
#include <vector>

namespace rt {

// The spheres of a scene, sorted for the renderers (given).
struct Prepared {
    std::vector<SceneSphere> still;  // lights, too
    std::vector<MovingSphere> moving;
    std::vector<Instance> instances;
    std::vector<SphereLight> lights;  // light k is the sphere of material materials.size() + k
};

inline Prepared prepare_spheres(const SceneDescription& scene) {
    Prepared prepared;
    const Real shutter = scene.camera.shutter;
    for (const SphereDescription& sphere : scene.spheres) {
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        const auto* const emitter = std::get_if<Emitter>(&material);
        if (sphere.map >= 0) {
            const Mat4& map = scene.maps[static_cast<std::size_t>(sphere.map)];
            prepared.instances.push_back(make_instance(map, sphere.material));
        } else if (emitter && emitter->radiance != Color{}) {
            const auto number = scene.materials.size() + prepared.lights.size();
            prepared.still.push_back({sphere.shape, static_cast<int>(number)});
            prepared.lights.push_back({sphere.shape, emitter->radiance});
        } else if (shutter > 0 && sphere.velocity != Vec3{}) {
            prepared.moving.push_back({sphere.shape, shutter * sphere.velocity, sphere.material});
        } else {
            prepared.still.push_back({sphere.shape, sphere.material});
        }
    }
    return prepared;
}

// A material as a renderer uses it: metal without fuzz, which draws no random numbers, is a Mirror,
// and an image is looked up.
using ReadyMaterial =
    std::variant<Lambertian, Mirror, Metal, Dielectric, CheckeredMatte, ImageMatte, OwnMaterial>;

inline ReadyMaterial ready(const MaterialDescription& material, const std::vector<Image>& images) {
    struct Sort {
        const std::vector<Image>& images;
        ReadyMaterial operator()(const Metal& metal) const {
            if (metal.fuzz == 0) return Mirror{metal.albedo};
            return metal;
        }
        ReadyMaterial operator()(const PictureMatte& picture) const {
            return ImageMatte{&images[static_cast<std::size_t>(picture.image)]};
        }
        // Only an emitter without light is ever asked what it reflects, which is nothing.
        ReadyMaterial operator()(const Emitter&) const { return Lambertian{}; }
        ReadyMaterial operator()(const Lambertian& matte) const { return matte; }
        ReadyMaterial operator()(const Dielectric& glass) const { return glass; }
        ReadyMaterial operator()(const CheckeredMatte& checker) const { return checker; }
        ReadyMaterial operator()(const OwnMaterial& own) const { return own; }
    };
    return std::visit(Sort{images}, material);
}

// The materials of a scene as a renderer keeps them, a MaterialList or a MaterialSet. If the
// renderer does not have a material's type, no sphere is made of it.
template <class Materials>
Materials prepare_materials(const SceneDescription& scene) {
    using Element = typename decltype(Materials::materials)::value_type;
    Materials prepared;
    for (const MaterialDescription& material : scene.materials)
        std::visit(
            [&](const auto& kind) {
                if constexpr (std::is_constructible_v<Element, decltype(kind)>)
                    prepared.materials.emplace_back(kind);
                else
                    prepared.materials.emplace_back(Lambertian{});
            },
            ready(material, scene.images));
    return prepared;
}

}  // namespace rt
