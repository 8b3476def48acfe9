#pragma once
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/render_tiles.hpp>
#include <rt/show_paths.hpp>

namespace rt {

// What --show asks for, of a scene (given), drawn by a renderer that has these effects. Settings
// that a scene has, too, are those of the program.
template <Effects effects>
app::Picture show_description(SceneDescription scene, const app::Settings& settings,
                              app::Progress& progress) {
    // A hit is that of a pinhole camera at the moment at which the shutter opens.
    if (settings.show != "bounces" && settings.show != "samples") {
        scene.camera.lens = {};
        scene.camera.shutter = 0;
    }
    if (settings.show == "sphere") {
        // Each sphere gets a material of its own, whose number then says which sphere was hit.
        const auto shared = std::move(scene.materials);
        scene.materials.clear();
        for (SphereDescription& sphere : scene.spheres) {
            scene.materials.push_back(shared[static_cast<std::size_t>(sphere.material)]);
            sphere.material = static_cast<int>(scene.materials.size()) - 1;
        }
    }
    const ReadyScene<effects> ready{scene, settings.width, settings.height};
    const auto path = [&](const auto& ray, const auto& world, Rng& random) {
        return lit_path_radiance(ray, world, ready.materials, ready.sky, ready.lights, ready.fog,
                                 SkyEnding{}, settings.depth, random);
    };
    return show_world(settings, progress, ready.camera, ready.world, path, render_tiles);
}

}  // namespace rt
