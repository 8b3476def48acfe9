#pragma once
#include <rt/compiler.hpp>
#include <rt/counting_world.hpp>
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sample_rng.hpp>
#include <rt/through_haze.hpp>
#include <utility>

namespace rt {

// The samples of a pixel (given). Each has its own cell (04.5) and its own random numbers (06.4),
// so none depends on how many numbers another sample draws.
struct JitteredSamples {
    std::uint64_t seed = 1;
    int count = 1;

    // The average of path(ray, random) over the samples.
    template <class AnyCamera, class Path>
    Color average(const AnyCamera& camera, int column, int row, const Path& path) const {
        Rng places = pixel_rng(seed, column, row);
        int sample = 0;
        return pixel_average(count, places, [&](Vec2 offset) {
            Rng random = sample_rng(seed, column, row, sample++);
            return path(make_ray(camera, column, row, offset, random), random);
        });
    }
};

// A renderer that has exactly these effects (given). Scene is the type of the scene once it is
// ready to be drawn.
template <Effects effects, class Scene = ReadyScene<effects>>
class Renderer {
  public:
    // The effects must cover those that the scene calls for. The scene must outlive the renderer.
    // `more` holds further arguments for the constructor of Scene.
    template <class... More>
    Renderer(const SceneDescription& scene, int width, int height, const Quality& quality,
             More&&... more)
        : scene_{scene, width, height, std::forward<More>(more)...}, quality_{quality} {}

    // The color of a pixel, which depends on the scene, the quality and the pixel alone.
    Color operator()(int column, int row) const {
        return pixel(scene_.world, samples(), column, row);
    }

    // The same, but also counts the rays.
    Color operator()(int column, int row, std::uint64_t& rays) const {
        return (*this)(samples(), column, row, rays);
    }

    // The same, but with these samples instead of the quality's. Samples has an average() like
    // that of JitteredSamples.
    template <class Samples>
    Color operator()(const Samples& samples, int column, int row, std::uint64_t& rays) const {
        return pixel(CountingWorld<decltype(Scene::world)>{scene_.world, rays}, samples, column,
                     row);
    }

  private:
    JitteredSamples samples() const { return {quality_.seed, quality_.samples_per_pixel}; }

    template <World AnyWorld, class Samples>
    Color pixel(const AnyWorld& world, const Samples& samples, int column, int row) const {
        // With lights and one of these, there is so much to inline that the renderer would take up
        // to three times as long to compile.
        if constexpr (effects.lights &&
                      (effects.instances || effects.motion || effects.fog || effects.own))
            return average(world, samples, column, row);
        else
            return inlined_average(world, samples, column, row);
    }

    template <World AnyWorld, class Samples>
    RT_INLINES_ALL Color inlined_average(const AnyWorld& world, const Samples& samples, int column,
                                         int row) const {
        return average(world, samples, column, row);
    }

    template <World AnyWorld, class Samples>
    Color average(const AnyWorld& world, const Samples& samples, int column, int row) const {
        return samples.average(scene_.camera, column, row, [&](const auto& ray, auto& random) {
            return through_haze(scene_.haze, radiance(world, ray, random),
                                [&] { return distance_ahead(world, ray); });
        });
    }

    // The light along one path, followed by chapter 04's loop or by this chapter's.
    template <World AnyWorld, class AnyRay, class Random>
    Color radiance(const AnyWorld& world, const AnyRay& ray, Random& random) const {
        if constexpr (effects.lights || effects.fog)
            return lit_path_radiance(ray, world, scene_.materials, scene_.sky, scene_.lights,
                                     scene_.fog, SkyEnding{}, quality_.depth, random);
        else
            return path_radiance(ray, world, scene_.materials, scene_.sky, SkyEnding{},
                                 quality_.depth, random);
    }

    Scene scene_;
    Quality quality_;
};

}  // namespace rt
