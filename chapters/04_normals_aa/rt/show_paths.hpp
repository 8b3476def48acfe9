#pragma once
#include <app/errors.hpp>
#include <cmath>
#include <rt/make_camera.hpp>
#include <rt/render_pixel.hpp>
#include <rt/scene_sphere.hpp>
#include <rt/show.hpp>

namespace rt {

// A world that counts the hits along a path (given).
template <class World>
struct HitCounter {
    const World& world;
    int& hits;

    template <class AnyRay>
    std::optional<Hit> hit(const AnyRay& ray, Interval within) const {
        const std::optional<Hit> found = world.hit(ray, within);
        hits += found.has_value();
        return found;
    }
    // Shadow rays, from chapter 08 on, are no part of the path.
    template <class AnyRay>
    bool occluded(const AnyRay& ray, Interval within, int number) const {
        return world.occluded(ray, within, number);
    }
};

// Gives each sphere a material of its own, whose number then says which sphere was hit.
inline void number_materials(std::vector<SceneSphere>& spheres) {
    for (std::size_t i = 0; i < spheres.size(); ++i) spheres[i].material = static_cast<int>(i);
}

// What the ray through the middle of a pixel meets first.
template <class AnyRay, class World>
Shown show_hit(const std::string& word, const AnyRay& ray, const World& world) {
    const std::optional<Hit> hit = world.hit(ray, Interval{0, infinity});
    if (!hit) return {};
    if (word == "normal") return hit->normal;
    if (word == "sphere") return hit->material;
    return hit->t;
}

// The standard deviation, 0 or more, of at least 2 numbers.
inline Real deviation_of(const std::vector<Real>& numbers) {
    const auto count = static_cast<Real>(numbers.size());
    Real sum = 0, squares = 0;
    for (const Real x : numbers) sum += x;
    for (const Real x : numbers) squares += (x - sum / count) * (x - sum / count);
    return std::sqrt(squares / (count - 1));
}

// What --show asks for (given), of a program that follows paths: path(ray, world, random) gives the
// light of one. Where it asks for the sphere, each sphere has a material of its own.
template <class AnyCamera, class World, class Path>
app::Picture show_world(const app::Settings& settings, app::Progress& progress,
                        const AnyCamera& camera, const World& world, const Path& path,
                        Strategy strategy = app::one_row_after_another) {
    const std::string& word = settings.show;
    if (word == "samples" && settings.spp == 1)
        throw app::UsageError("--show samples compares the samples of a pixel: --spp 2 or more");
    const auto compute = [&](int x, int y) -> Shown {
        Rng random = pixel_rng(*settings.seed, x, y);
        if (word != "bounces" && word != "samples")
            return show_hit(word, make_ray(camera, x, y, {Real(0.5), Real(0.5)}, random), world);
        int hits = 0;
        std::vector<Real> lights;
        pixel_average(settings.spp, random, [&](Vec2 offset) {
            const Color light = path(make_ray(camera, x, y, offset, random),
                                     HitCounter<World>{world, hits}, random);
            lights.push_back((light.r + light.g + light.b) / 3);
            return light;
        });
        if (hits == 0) return {};
        if (word == "samples") return deviation_of(lights);
        return static_cast<Real>(hits) / static_cast<Real>(settings.spp);
    };
    return app::show(settings, progress, compute, strategy);
}

// The same for the camera of the settings and the path loop of chapter 04.
template <class World, class Materials, class Sky, class Ending>
app::Picture show_paths(const app::Settings& settings, app::Progress& progress, const World& world,
                        const Materials& materials, const Sky& sky, const Ending& ending,
                        Strategy strategy = app::one_row_after_another) {
    const Camera camera = make_camera(*settings.view, settings.width, settings.height);
    const auto path = [&](const Ray& ray, const auto& counting, Rng& random) {
        return path_radiance(ray, counting, materials, sky, ending, settings.depth, random);
    };
    return show_world(settings, progress, camera, world, path, strategy);
}

}  // namespace rt
