#include "show_scene.hpp"

#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/render_tiles.hpp>
#include <rt/show_paths.hpp>

namespace effects {

using namespace rt;

app::Picture show_scene(SceneDescription scene, app::Settings settings, app::Progress& progress) {
    settings.width = scene.settings.width;
    settings.height = scene.settings.height;
    settings.spp = scene.settings.samples_per_pixel;
    settings.seed = scene.settings.seed;
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
    const ReadyScene<every_effect> ready{scene, settings.width, settings.height};
    const auto path = [&](const auto& ray, const auto& world, Rng& random) {
        return lit_path_radiance(ray, world, ready.materials, ready.sky, ready.lights, ready.fog,
                                 SkyEnding{}, scene.settings.depth, random);
    };
    return show_world(settings, progress, ready.camera, ready.world, path, render_tiles);
}

}  // namespace effects
