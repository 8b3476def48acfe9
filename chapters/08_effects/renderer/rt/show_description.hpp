#pragma once
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/render_tiles.hpp>
#include <rt/show_paths.hpp>
#include <string>
#include <utility>

namespace rt {

// Draws what --show asks for, of a scene that is ready to be drawn (given).
template <class Scene>
app::Picture show_ready(const Scene& scene, const app::Settings& settings,
                        app::Progress& progress) {
    const auto path = [&](const auto& ray, const auto& world, Rng& random) {
        return lit_path_radiance(ray, world, scene.materials, scene.sky, scene.lights, scene.fog,
                                 SkyEnding{}, settings.depth, random);
    };
    return show_world(settings, progress, scene.camera, scene.world, path, render_tiles,
                      &Hit::material);
}

// Prepares the camera for --show (given): unless bounces or samples are asked for, the camera
// becomes a pinhole camera whose shutter closes at the moment at which it opens.
inline void hold_still(CameraDescription& camera, const std::string& show) {
    if (show == "bounces" || show == "samples") return;
    camera.lens = {};
    camera.shutter = 0;
}

// Draws what --show asks for, of a scene (given), with a renderer that has these effects. The
// settings of the program count, not those of the scene.
template <Effects effects>
app::Picture show_description(SceneDescription scene, const app::Settings& settings,
                              app::Progress& progress) {
    hold_still(scene.camera, settings.show);
    if (settings.show == "sphere") {
        // Each sphere gets a material of its own, whose number then says which sphere was hit. The
        // materials of other shapes come after those.
        const auto shared = std::move(scene.materials);
        scene.materials.clear();
        for (SphereDescription& sphere : scene.spheres) {
            scene.materials.push_back(shared[static_cast<std::size_t>(sphere.material)]);
            sphere.material = static_cast<int>(scene.materials.size()) - 1;
        }
        const auto spheres = static_cast<int>(scene.spheres.size());
        for_other_shapes(scene, [&](int& material) { material += spheres; });
        scene.materials.insert(scene.materials.end(), shared.begin(), shared.end());
    }
    return show_ready(ReadyScene<effects>{scene, settings.width, settings.height}, settings,
                      progress);
}

}  // namespace rt
