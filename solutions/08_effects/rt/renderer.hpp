#pragma once
#include <rt/compiler.hpp>
#include <rt/counting_world.hpp>
#include <rt/lit_path.hpp>
#include <rt/ready_scene.hpp>
#include <rt/render_pixel.hpp>
#include <rt/sample_rng.hpp>

namespace rt {

// Draws a scene with these effects, and no others (given).
template <Effects effects>
class Renderer {
  public:
    // The effects must cover those of the scene, which must outlive the renderer.
    Renderer(const SceneDescription& scene, int width, int height, const Quality& quality)
        : scene_{scene, width, height}, quality_{quality} {}

    // The color of a pixel, which depends on the scene, the quality and the pixel alone.
    Color operator()(int column, int row) const { return pixel(scene_.world, column, row); }

    // The same, and counts the rays.
    Color operator()(int column, int row, std::uint64_t& rays) const {
        return pixel(CountingWorld<typename Parts<effects>::World>{scene_.world, rays}, column,
                     row);
    }

  private:
    template <class World>
    Color pixel(const World& world, int column, int row) const {
        if constexpr (effects.lights || effects.fog)
            return lit_pixel(world, column, row);
        else
            return plain_pixel(world, column, row);
    }

    // The average of path(ray, random) over the samples of a pixel. Each has random numbers of its
    // own (06.4), so that none depends on how many another one draws.
    template <class Path>
    Color average(int column, int row, const Path& path) const {
        Rng places = pixel_rng(quality_.seed, column, row);
        int sample = 0;
        return pixel_average(quality_.samples_per_pixel, places, [&](Vec2 offset) {
            Rng random = sample_rng(quality_.seed, column, row, sample++);
            return path(make_ray(scene_.eye, column, row, offset, random), random);
        });
    }

    template <class World>
    RT_INLINES_ALL Color plain_pixel(const World& world, int column, int row) const {
        return average(column, row, [&](const auto& ray, Rng& random) {
            return path_radiance(ray, world, scene_.materials, scene_.sky, SkyEnding{},
                                 quality_.depth, random);
        });
    }

    // The same with the loop of this chapter.
    template <class World>
    Color lit_pixel(const World& world, int column, int row) const {
        return average(column, row, [&](const auto& ray, Rng& random) {
            return lit_path_radiance(ray, world, scene_.materials, scene_.sky, scene_.lights,
                                     scene_.fog, SkyEnding{}, quality_.depth, random);
        });
    }

    ReadyScene<effects> scene_;
    Quality quality_;
};

}  // namespace rt
