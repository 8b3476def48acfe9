#pragma once
#include <app/errors.hpp>
#include <rt/make_camera.hpp>
#include <rt/show.hpp>
#include <rt/shown_pixel.hpp>

namespace rt {

// Draws what --show asks for, in a program that follows paths (given): path(ray, world, random)
// gives the light of one path.
template <class AnyCamera, World AnyWorld, class Path>
app::Picture show_world(const app::Settings& settings, app::Progress& progress,
                        const AnyCamera& camera, const AnyWorld& world, const Path& path,
                        Strategy strategy = app::one_row_after_another,
                        SphereNumber number = &Hit::shape) {
    const std::string& word = settings.show;
    if (word == "samples" && settings.spp == 1)
        throw app::UsageError("--show samples compares the samples of a pixel: --spp 2 or more");
    const auto compute = [&](int x, int y) {
        return shown_pixel(word, camera, world, path, settings.spp, *settings.seed, x, y, number);
    };
    return app::show(settings, progress, compute, strategy);
}

// The same, with the camera that the settings describe and the path loop of chapter 04.
template <World AnyWorld, class Materials, class Sky, Ending AnyEnding>
app::Picture show_paths(const app::Settings& settings, app::Progress& progress,
                        const AnyWorld& world, const Materials& materials, const Sky& sky,
                        const AnyEnding& ending, Strategy strategy = app::one_row_after_another) {
    const Camera camera = make_camera(*settings.view, settings.width, settings.height);
    const auto path = [&](const Ray& ray, const auto& counting, Rng& random) {
        return path_radiance(ray, counting, materials, sky, ending, settings.depth, random);
    };
    return show_world(settings, progress, camera, world, path, strategy);
}

}  // namespace rt
