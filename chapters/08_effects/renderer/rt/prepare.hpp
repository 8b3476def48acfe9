#pragma once
#include <rt/aggregate.hpp>
#include <rt/instance_shape.hpp>
#include <rt/lambertian.hpp>
#include <rt/lights.hpp>
#include <rt/mirror_and_motion.hpp>
#include <rt/renderer_materials.hpp>
#include <rt/scene.hpp>
#include <rt/wide_builder.hpp>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace rt {

// The shapes of a scene, sorted by type for the renderers (given).
struct Prepared {
    std::vector<SceneSphere> still;  // including the lights
    std::vector<MovingSphere> moving;
    std::vector<Instance> instances;
    std::vector<Light> lights;
};

inline Prepared prepare_shapes(const SceneDescription& scene) {
    Prepared prepared;
    const Real shutter = scene.camera.shutter;
    for (const SphereDescription& sphere : scene.spheres) {
        const auto& material = scene.materials[static_cast<std::size_t>(sphere.material)];
        const auto* const emitter = std::get_if<Emitter>(&material);
        if (sphere.map >= 0) {
            const Mat4& map = scene.maps[static_cast<std::size_t>(sphere.map)];
            prepared.instances.push_back(make_instance(map, sphere.material));
        } else if (emitter && emitter->radiance != Color{}) {
            const auto light = static_cast<int>(prepared.lights.size());
            const auto in_tree = static_cast<int>(prepared.still.size());
            prepared.still.push_back({sphere.shape, sphere.material, light});
            prepared.lights.push_back({sphere.shape, emitter->radiance, light, in_tree});
        } else if (shutter > 0 && sphere.velocity != Vec3{}) {
            prepared.moving.push_back({sphere.shape, shutter * sphere.velocity, sphere.material});
        } else {
            prepared.still.push_back({sphere.shape, sphere.material});
        }
    }
    return prepared;
}

// A tree of shapes if `present` is true, and otherwise NoWorld (given).
template <bool present, class Shape>
auto tree_if(const std::vector<Shape>& shapes) {
    if constexpr (present)
        return make_tree(shapes, AreaSplit{});
    else
        return NoWorld{};
}

// The world of a renderer with these effects: one tree for each type of shape (given). Spheres that
// stand still come first, because most spheres do, and because the lights are among them.
template <Effects effects>
auto make_world(const Prepared& shapes) {
    auto spheres = both(make_wide_tree(shapes.still), tree_if<effects.motion>(shapes.moving));
    return both(std::move(spheres), tree_if<effects.instances>(shapes.instances));
}

// A material as renderers keep it.
template <class Material>
ReadyMaterial ready(const Material& material, const SceneDescription&) {
    return material;
}
inline ReadyMaterial ready(const Metal& metal, const SceneDescription&) {
    if (metal.fuzz == 0) return Mirror{metal.albedo};
    return metal;
}
inline ReadyMaterial ready(const PictureMatte& picture, const SceneDescription& scene) {
    return ImageMatte{
        &scene.images[static_cast<std::size_t>(picture.image)],
        picture.map < 0 ? nullptr : &scene.maps[static_cast<std::size_t>(picture.map)]};
}
// An emitter reflects nothing.
inline ReadyMaterial ready(const Emitter&, const SceneDescription&) {
    return Lambertian{};
}
// What draws this metal keeps it apart from the other materials.
inline ReadyMaterial ready(const RoughDescription&, const SceneDescription&) {
    return Lambertian{};
}

// The materials of a scene as a renderer keeps them, a MaterialList or a MaterialSet. A material
// whose type the renderer does not have becomes black and matte.
template <class Materials>
Materials prepare_materials(const SceneDescription& scene) {
    using Element = typename decltype(Materials::materials)::value_type;
    Materials prepared;
    const auto add = [&](const auto& material) {
        if constexpr (std::is_constructible_v<Element, decltype(material)>)
            prepared.materials.emplace_back(material);
        else
            prepared.materials.emplace_back(Lambertian{});
    };
    for (const MaterialDescription& description : scene.materials)
        std::visit([&](const auto& material) { std::visit(add, ready(material, scene)); },
                   description);
    return prepared;
}

}  // namespace rt
